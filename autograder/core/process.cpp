#include "core/process.h"

#include <fmt/format.h>

#include <csignal>
#include <cstring>

namespace penumbra {

namespace {

std::string signalName(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "segmentation fault";
        case SIGABRT:
            return "aborted";
        case SIGFPE:
            return "division by zero";
        case SIGILL:
            return "illegal instruction";
#if !defined(_WIN32)
        case SIGBUS:
            return "bus error";
        case SIGKILL:
            return "killed";
#endif
        default:
            return fmt::format("signal {}", signal);
    }
}

}  // namespace

std::string inWords(const ProcessResult& result, const ProcessLimits& limits) {
    using End = ProcessResult::End;
    switch (result.end) {
        case End::exited:
            return fmt::format("ended with exit code {}", result.code);
        case End::signalled:
            return fmt::format("crashed ({})", signalName(result.code));
        case End::wallLimit:
            return fmt::format("ran past its limit of {:g} s", limits.wallSeconds);
        case End::cpuLimit:
            return fmt::format("ran past its limit of {:g} s of processor time", limits.cpuSeconds);
        case End::memoryLimit:
            return fmt::format("needs more than {} MB of memory", limits.memoryBytes >> 20);
        case End::fileLimit:
            return fmt::format("writes a file of more than {} MB", limits.fileBytes >> 20);
        case End::notStarted:
            return fmt::format("cannot be started ({})", std::strerror(result.code));
    }
    return "";
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace penumbra
