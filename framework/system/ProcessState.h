#pragma once
/// \file
/// What belongs to a whole process and any code in it may change: its folder, limits, signals, environment,
/// …. Planners from plugins share a worker process with the planners of later runs, which must not notice.

#include <array>
#include <cfenv>
#include <csignal>
#include <exception>
#include <locale>
#include <new>
#include <sched.h>
#include <string>
#include <sys/resource.h>
#include <sys/types.h>
#include <vector>

namespace mrpp
{

class ProcessState
{
public:
    /// Notes how this process is now.
    ProcessState();
    ~ProcessState();
    ProcessState(const ProcessState &) = delete;
    ProcessState &operator=(const ProcessState &) = delete;

    /// Makes the process again as it was: folder, umask, resource limits, signal handlers and mask, timers,
    /// environment, locale, priority, cores, rounding mode. False where that is impossible: a hard limit was
    /// lowered, descriptors or threads are left or gone, rights were given up; then it should serve nobody
    /// any more. Some hundred system calls, 20 µs. To be called by the thread that made the object.
    [[nodiscard]] bool restore() const;

private:
    static constexpr int kSignals = NSIG; ///< numbers below

    [[nodiscard]] bool restoreFolder() const;
    [[nodiscard]] bool restoreLimits() const;
    void restoreSignals() const;
    void restoreEnvironment() const;
    [[nodiscard]] bool restoreScheduling() const;

    /// Which file is behind a descriptor.
    struct File
    {
        dev_t device = 0;
        ino_t number = 0;
        bool operator==(const File &) const = default;
    };
    /// What cannot be taken back.
    struct Lasting
    {
        std::array<File, 4> open = {}; ///< behind the descriptors 0 to 3
        int firstFree = 0;             ///< descriptor
        std::size_t threads = 0;
        File root;
        std::array<uid_t, 3> user = {};
        std::array<gid_t, 3> group = {};
        int noNewRights = 0;
        int systemCalls = 0; ///< how they are filtered
        bool operator==(const Lasting &) const = default;
    };
    [[nodiscard]] static Lasting lastingNow();

    int folder_;
    mode_t umask_;
    std::array<rlimit, RLIM_NLIMITS> limits_ = {};
    std::array<struct sigaction, kSignals> actions_ = {};
    sigset_t blocked_ = {};
    std::vector<std::string> environment_;
    std::locale streams_;
    std::string locale_;
    std::new_handler outOfMemory_ = std::get_new_handler();
    std::terminate_handler atTheEnd_ = std::get_terminate();
    int priority_;
    cpu_set_t cores_ = {};
    std::fenv_t rounding_ = {};
    Lasting lasting_;
};

} // namespace mrpp
