#include "core/interruption.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <set>
#include <stdexcept>
#include <thread>

namespace braidzone {
namespace {

struct Unfinished {
    std::recursive_mutex mutex;
    std::set<std::filesystem::path> paths;
};

/// Never destroyed: the waiting thread may use it while the program ends.
Unfinished& unfinished()
{
    static auto& held = *new Unfinished;
    return held;
}

/// Another thread may still be writing into the folder, so that a removal finds it not empty.
void remove_stubbornly(const std::filesystem::path& path)
{
    for (int attempt = 0; attempt < 100; ++attempt) {
        std::error_code error;
        std::filesystem::remove_all(path, error);
        if (!error) return;
    }
}

/// Ends of the pipe through which the handler passes a signal on: read, write.
std::array<int, 2> passage = {-1, -1};

/// On whatever thread the signal arrives, a library's too: write() may be called here.
void pass_on(int signal)
{
    const int error = errno;
    const char number = static_cast<char>(signal);
    [[maybe_unused]] const auto written = ::write(passage[1], &number, 1);
    errno = error;
}

void wait_for_signal()
{
    char number = 0;
    while (::read(passage[0], &number, 1) != 1) {
    }
    const int signal = number;
    const std::scoped_lock nothing_is_finished(unfinished().mutex);
    for (const auto& path : unfinished().paths)
        remove_stubbornly(path);

    // End by the signal itself, so that the caller sees it.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

}  // namespace

void remove_unfinished_output_on_signal()
{
    if (::pipe(passage.data()) != 0) throw std::runtime_error("no pipe can be opened");
    std::thread(wait_for_signal).detach();
    struct sigaction handling = {};
    handling.sa_handler = pass_on;
    handling.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before = {};
        ::sigaction(signal, nullptr, &before);
        const bool is_nohup = signal == SIGHUP && before.sa_handler == SIG_IGN;
        if (!is_nohup) ::sigaction(signal, &handling, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

UnfinishedOutput::UnfinishedOutput(std::filesystem::path path) : path_(std::move(path))
{
    const std::scoped_lock lock(mutex());
    unfinished().paths.insert(path_);
}

UnfinishedOutput::~UnfinishedOutput()
{
    const std::scoped_lock lock(mutex());
    if (!unfinished().paths.contains(path_)) return;
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    forget();
}

std::recursive_mutex& UnfinishedOutput::mutex()
{
    return unfinished().mutex;
}

void UnfinishedOutput::forget()
{
    unfinished().paths.erase(path_);
}

}  // namespace braidzone
