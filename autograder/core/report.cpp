#include "core/report.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>

#include "core/error.h"

namespace penumbra {

namespace fs = std::filesystem;

namespace {

const char* const kReports[] = {"results.json", "junit.xml", "report.html"};

void write(const fs::path& path, const std::string& text) {
    std::ofstream stream(path, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
        throw Error("cannot write report", path.string(), "check the folder and the disk's space");
}

// The length of the UTF-8 character at `i`, 0 where there is none that XML may hold.
std::size_t characterLength(const std::string& s, std::size_t i) {
    const auto byte = [&](std::size_t k) {
        return std::uint32_t(static_cast<unsigned char>(s[k]));
    };
    const std::uint32_t first = byte(i);
    if (first < 0x80) return first >= 0x20 || first == '\n' || first == '\t' ? 1 : 0;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || i + length > s.size()) return 0;
    std::uint32_t code = first & (0x7fu >> length);
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(i + k) & 0xc0u) != 0x80u) return 0;
        code = (code << 6) | (byte(i + k) & 0x3fu);
    }
    const bool shortest = code >= (length == 4 ? 0x10000u : length == 3 ? 0x800u : 0x80u);
    const bool legal =
        code <= 0x10ffffu && (code < 0xd800u || code > 0xdfffu) && (code & 0xfffeu) != 0xfffeu;
    return shortest && legal ? length : 0;
}

int columns(const std::string& utf8) {
    int count = 0;
    for (const char c : utf8) count += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    return count;
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = characterLength(text, i);
        if (length == 0) {
            result += "\xef\xbf\xbd";
            ++i;
            continue;
        }
        switch (text[i]) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                result.append(text, i, length);
        }
        i += length;
    }
    return result;
}

void prepareOut(const fs::path& out) {
    std::error_code error;
    fs::create_directories(out, error);
    if (!fs::is_directory(out))
        throw Error("cannot make folder", out.string(), error ? error.message() : "it is a file");
    for (const char* name : kReports) fs::remove(out / name, error);
}

void writeReports(const fs::path& out, const GradeRecord& grade) {
    // Inside `out`, since that may be a mount point (Gradescope's /autograder/results).
    const fs::path part = out / ".part";
    try {
        fs::create_directories(part);
        write(part / "results.json", resultsJson(grade));
        write(part / "junit.xml", junitXml(grade));
        write(part / "report.html", reportHtml(grade, out));
        for (const char* name : kReports) fs::rename(part / name, out / name);
        fs::remove_all(part);
    } catch (const std::exception& error) {
        std::error_code ignored;
        fs::remove_all(part, ignored);
        throw Error("cannot write the reports", out.string(), error.what());
    }
}

void printTable(const GradeRecord& grade, const fs::path& out) {
    int width = 20;
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks) width = std::max(width, columns(check.sentence));
    fmt::print("\n{} · {}\n\n", grade.title, grade.variant);
    for (const auto& task : grade.tasks)
        for (const auto& check : task.checks) {
            fmt::print("  {}{}  {:<12} {:>4g} of {:g}\n", check.sentence,
                       std::string(std::size_t(width - columns(check.sentence)), ' '),
                       toString(check.verdict), check.points, check.maximum);
            if (check.verdict == Verdict::fail || check.verdict == Verdict::graderError)
                for (const auto& reason : check.reasons) fmt::print("      {}\n", reason);
        }
    for (const auto& warning : grade.warnings) fmt::print("\n  note: {}", warning);
    if (!grade.looksLike.empty()) fmt::print("\n  looks like: {}\n", grade.looksLike);
    fmt::print("\n  {:g} of {:g} points   {:.0f} s, {} frames, largest process {} MB\n  {}\n",
               pointsOf(grade), maximumOf(grade), grade.seconds, grade.runs, grade.peakBytes >> 20,
               (out / "report.html").string());
}

}  // namespace penumbra
