#if !defined(_WIN32)
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include "core/error.h"
#include "core/process.h"

namespace penumbra {

namespace {

using Clock = std::chrono::steady_clock;
using End = ProcessResult::End;
namespace fs = std::filesystem;

struct Pipe {
    Pipe() {
        int ends[2];
        if (pipe(ends) != 0) throw Error("cannot make a pipe", "grader", std::strerror(errno));
        read = ends[0], write = ends[1];
        fcntl(read, F_SETFD, FD_CLOEXEC);
        fcntl(write, F_SETFD, FD_CLOEXEC);
        fcntl(read, F_SETFL, O_NONBLOCK);
    }
    ~Pipe() { closeRead(), closeWrite(); }
    void closeRead() {
        if (read >= 0) close(read), read = -1;
    }
    void closeWrite() {
        if (write >= 0) close(write), write = -1;
    }

    // Takes what is there. The child may write for ever: only the first `limit` bytes are kept.
    void drain(std::string& text, std::size_t limit) {
        char buffer[8192];
        for (int i = 0; read >= 0 && i < 64; ++i) {
            const ssize_t n = ::read(read, buffer, sizeof buffer);
            if (n > 0)
                text.append(buffer, std::min(std::size_t(n), limit - std::min(limit, text.size())));
            if (n == 0) closeRead();
            if (n < 0) return;
        }
    }

    int read = -1;
    int write = -1;
};

// What the child gets to see. Drivers are chosen by the first group; the second serves sanitised
// and relocated builds.
std::vector<std::string> reducedEnvironment(const Command& command) {
    const std::string folder = command.folder.string();
    std::vector<std::string> environment = command.environment;  // the first of a name counts
    environment.insert(environment.end(),
                       {"PATH=/usr/local/bin:/usr/bin:/bin", "LANG=C.UTF-8", "HOME=" + folder,
                        "TMPDIR=" + folder, "MESA_SHADER_CACHE_DIR=" + folder + "/cache"});
    for (const char* name :
         {"PENUMBRA_CONTEXT", "LP_NUM_THREADS", "GALLIUM_DRIVER", "LIBGL_ALWAYS_SOFTWARE",
          "EGL_PLATFORM", "__EGL_VENDOR_LIBRARY_FILENAMES", "DISPLAY", "LD_LIBRARY_PATH",
          "DYLD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS", "LSAN_OPTIONS"})
        if (const char* value = std::getenv(name))
            environment.push_back(std::string(name) + "=" + value);
    return environment;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (auto& s : strings) result.push_back(s.data());
    result.push_back(nullptr);
    return result;
}

void limit(decltype(RLIMIT_CORE) what, rlim_t soft, rlim_t hard) {
    const rlimit both{soft, hard};
    setrlimit(what, &both);
}

// Between fork and exec: system calls only, since another thread may have held the allocator's
// lock.
[[noreturn]] void becomeProgram(const Command& c, char* const* argv, char* const* envp, int out,
                                int err, int status) {
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, 0), dup2(out, 1), dup2(err, 2);
    for (int fd = 3; fd < 1024; ++fd)
        if (fd != status) close(fd);
    const auto cpu = rlim_t(std::ceil(c.limits.cpuSeconds));
    limit(RLIMIT_CPU, cpu, cpu + 2);
    limit(RLIMIT_FSIZE, c.limits.fileBytes, c.limits.fileBytes);
    limit(RLIMIT_CORE, 0, 0);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    for (int s : {SIGINT, SIGPIPE, SIGXFSZ, SIGXCPU, SIGTERM, SIGCHLD}) signal(s, SIG_DFL);
    if (chdir(c.folder.c_str()) == 0) execve(c.program.c_str(), argv, envp);
    const int error = errno;
    if (write(status, &error, sizeof error) < 0) _exit(126);
    _exit(127);
}

// Resident set and its peak so far, in bytes; 0 where the system does not tell.
std::size_t memory(pid_t pid, const char* key) {
    std::ifstream status(fmt::format("/proc/{}/status", pid));
    for (std::string line; std::getline(status, line);)
        if (line.rfind(key, 0) == 0)
            return std::strtoull(line.c_str() + std::strlen(key), nullptr, 10) << 10;
    return 0;
}

bool hasEnded(pid_t pid) {
    siginfo_t info = {};
    return waitid(P_PID, id_t(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == pid;
}

// A grandchild that left the process group is ours by now (subreaper) and still carries the token.
void killOrphans(const std::string& token) {
#if defined(__linux__)
    std::error_code ignored;
    for (const auto& thread : fs::directory_iterator("/proc/self/task", ignored)) {
        std::ifstream children(thread.path() / "children");
        for (pid_t pid = 0; children >> pid;) {
            std::ifstream stream(fmt::format("/proc/{}/environ", pid), std::ios::binary);
            const std::string environment((std::istreambuf_iterator<char>(stream)), {});
            if (environment.find(token) == std::string::npos) continue;
            kill(pid, SIGKILL);
            waitpid(pid, nullptr, 0);
        }
    }
#else
    (void)token;
#endif
}

// Watches until the program ends or breaks a limit; says which, if one.
End watch(pid_t pid, const Command& command, Clock::time_point start, Pipe& out, Pipe& err,
          ProcessResult& result) {
    const auto& limits = command.limits;
    for (;;) {
        pollfd fds[2] = {{out.read, POLLIN, 0}, {err.read, POLLIN, 0}};
        const bool open = out.read >= 0 || err.read >= 0;
        poll(fds, 2, open ? 20 : 2);  // a closed pipe is -1, which poll() skips
        out.drain(result.standardOutput, limits.textBytes);
        err.drain(result.standardError, limits.textBytes);
        const bool ended = hasEnded(pid);
        result.peakBytes = std::max(result.peakBytes, memory(pid, "VmHWM:"));
        if (ended) return End::exited;
        if (std::chrono::duration<double>(Clock::now() - start).count() > limits.wallSeconds)
            return End::wallLimit;
        if (memory(pid, "VmRSS:") > limits.memoryBytes) return End::memoryLimit;
    }
}

void conclude(pid_t pid, End end, ProcessResult& result) {
    int status = 0;
    rusage usage = {};
    wait4(pid, &status, 0, &usage);
    // Linux counts the parent's pages at fork in ru_maxrss: the samples are the program's own.
    if (result.peakBytes == 0) {
#if defined(__APPLE__)
        result.peakBytes = std::size_t(usage.ru_maxrss);
#else
        result.peakBytes = std::size_t(usage.ru_maxrss) << 10;
#endif
    }
    result.end = end;
    if (end != End::exited) return;
    if (WIFEXITED(status)) {
        result.code = WEXITSTATUS(status);
    } else {
        result.code = WTERMSIG(status);
        result.end = result.code == SIGXCPU   ? End::cpuLimit
                     : result.code == SIGXFSZ ? End::fileLimit
                                              : End::signalled;
    }
}

}  // namespace

ProcessResult runProcess(const Command& command) {
    static std::atomic<int> runs = 0;
    const std::string token = fmt::format("PENUMBRA_RUN={}-{}", getpid(), int(++runs));
#if defined(__linux__)
    prctl(PR_SET_CHILD_SUBREAPER, 1);
#endif
    auto environment = reducedEnvironment(command);
    environment.push_back(token);
    std::vector<std::string> arguments = {command.program.string()};
    arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
    const auto argv = pointers(arguments), envp = pointers(environment);
    Pipe out, err, status;
    ProcessResult result;
    const auto start = Clock::now();
    const pid_t pid = fork();
    if (pid == 0)
        becomeProgram(command, argv.data(), envp.data(), out.write, err.write, status.write);
    if (pid < 0)
        throw Error("cannot start a process", command.program.string(), std::strerror(errno));
    setpgid(pid, pid);  // also here: whoever is first
    out.closeWrite(), err.closeWrite(), status.closeWrite();
    fcntl(status.read, F_SETFL, 0);
    int execError = 0;  // exec closes the pipe; only its failure is written
    const bool failed = read(status.read, &execError, sizeof execError) == sizeof execError;
    const End end = watch(pid, command, start, out, err, result);
    kill(-pid, SIGKILL);
    conclude(pid, end, result);
    killOrphans(token);
    out.drain(result.standardOutput, command.limits.textBytes);
    err.drain(result.standardError, command.limits.textBytes);
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (failed) result.end = End::notStarted, result.code = execError;
    return result;
}

ScratchFolder::ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "penumbra-XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error("cannot make a folder", name, std::strerror(errno));
    path_ = name;
}

}  // namespace penumbra
#endif
