// Milliseconds of a frame's parts: timestamps on a GPU; on a software rasteriser, whose queries
// time one tile only (Mesa 22.3, measured), glFinish and a steady clock.
//
//   Times times;
//   { auto timing = times.time("light"); … draw … }
//   times.milliseconds().at("light")     // after the frame: this waits for a GPU
#pragma once

#include <glad/gl.h>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

// True when times come from timer queries; said in frame.json.
bool usesTimerQueries();

class Times {
public:
    // `queries`: for tests; otherwise what suits the context.
    explicit Times(std::optional<bool> queries = std::nullopt) : queries_(queries) {}
    ~Times();
    Times(Times&& other) noexcept;
    Times& operator=(Times&&) = delete;

    // From its making to its end; spans may nest. The Times must stay where it is meanwhile.
    class Span {
    public:
        ~Span();
        Span(const Span&) = delete;
        Span& operator=(const Span&) = delete;

    private:
        friend class Times;
        Span(Times& times, const std::string& name);

        Times& times_;
        std::string name_;
        GLuint begin_ = 0;
        std::chrono::steady_clock::time_point start_;
    };
    Span time(const std::string& name) { return Span(*this, name); }

    // Of all spans that have ended; two of one name add up.
    const std::map<std::string, double>& milliseconds() const;

private:
    struct Pending {
        std::string name;
        GLuint begin, end;
    };

    std::optional<bool> queries_;
    mutable std::vector<Pending> pending_;  // timestamps that nobody has asked for yet
    mutable std::map<std::string, double> milliseconds_;
};

}  // namespace penumbra
