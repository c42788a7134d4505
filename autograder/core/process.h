// Runs a program that nobody trusts: its own process group, limits, bounded text, a clean
// environment.
//
//   ProcessResult r = runProcess({.program = bin / "05-shadow-map", .arguments = {"render", …},
//                                 .folder = scratch, .limits = {.wallSeconds = 20}});
//   if (r.end != ProcessResult::End::exited || r.exitCode != 0) reason = inWords(r, limits);
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace penumbra {

struct ProcessLimits {
    double wallSeconds = 20;
    double cpuSeconds = 80;  // of all threads together; llvmpipe uses every core it may
    // Resident, not virtual: drivers, JIT compilers and AddressSanitizer reserve address space that
    // they never touch, so a limit on it would stop honest programs.
    std::size_t memoryBytes = std::size_t(2) << 30;
    std::size_t fileBytes = std::size_t(256) << 20;  // each file that it writes
    std::size_t textBytes = 64 << 10;  // kept of stdout and of stderr; the rest is read and dropped
};

struct Command {
    std::filesystem::path program;
    std::vector<std::string> arguments = {};
    std::filesystem::path folder;               // working folder, HOME and TMPDIR
    std::vector<std::string> environment = {};  // NAME=value, on top of the reduced one
    ProcessLimits limits = {};
};

struct ProcessResult {
    enum class End { exited, signalled, wallLimit, cpuLimit, memoryLimit, fileLimit, notStarted };

    End end = End::notStarted;
    int code = 0;  // exit status, signal, or errno, after `end`
    std::string standardOutput;
    std::string standardError;
    double seconds = 0;
    std::size_t peakBytes = 0;  // resident
};

// Returns when the program has ended and nothing of its process group is left. stdin is empty.
// One file implements it for each system: process_posix.cpp.
ProcessResult runProcess(const Command& command);

// "crashed (segmentation fault)", "ran past its limit of 20 s", "ended with exit code 3".
std::string inWords(const ProcessResult& result, const ProcessLimits& limits);

// A folder of its own under the system's temporary one, removed with all it holds.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace penumbra
