#include "gl/timer.h"

#include <cstring>
#include <utility>

namespace penumbra {

namespace {

GLuint timestamp() {
    GLuint query = 0;
    glGenQueries(1, &query);
    glQueryCounter(query, GL_TIMESTAMP);
    return query;
}

GLuint64 takeNanoseconds(GLuint query) {
    GLuint64 result = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &result);
    glDeleteQueries(1, &query);
    return result;
}

}  // namespace

bool usesTimerQueries() {
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return renderer && !std::strstr(renderer, "llvmpipe") && !std::strstr(renderer, "softpipe") &&
           !std::strstr(renderer, "swrast");
}

Times::Times(Times&& other) noexcept
    : queries_(other.queries_),
      pending_(std::exchange(other.pending_, {})),
      milliseconds_(std::move(other.milliseconds_)) {}

Times::~Times() {
    for (const Pending& p : pending_) {
        glDeleteQueries(1, &p.begin);
        glDeleteQueries(1, &p.end);
    }
}

const std::map<std::string, double>& Times::milliseconds() const {
    for (const Pending& p : std::exchange(pending_, {})) {
        const GLuint64 begin = takeNanoseconds(p.begin), end = takeNanoseconds(p.end);
        milliseconds_[p.name] += 1e-6 * double(end - begin);
    }
    return milliseconds_;
}

Times::Span::Span(Times& times, const std::string& name) : times_(times), name_(name) {
    if (times.queries_.value_or(usesTimerQueries())) {
        begin_ = timestamp();
        glFlush();  // now, not with the end's: what the processor does in between counts
    } else {
        glFinish();
        start_ = std::chrono::steady_clock::now();
    }
}

Times::Span::~Span() {
    if (begin_) {
        times_.pending_.push_back({name_, begin_, timestamp()});
    } else {
        glFinish();
        const auto elapsed = std::chrono::steady_clock::now() - start_;
        times_.milliseconds_[name_] += std::chrono::duration<double, std::milli>(elapsed).count();
    }
}

}  // namespace penumbra
