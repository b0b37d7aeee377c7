#include "cli/interruption.hpp"

#include <csignal>
#include <set>
#include <thread>

namespace braidzone {
namespace {

struct Unfinished {
    std::mutex mutex;
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

void wait_for_signal(sigset_t signals)
{
    int signal = 0;
    sigwait(&signals, &signal);
    const std::scoped_lock nothing_is_finished(unfinished().mutex);
    for (const auto& path : unfinished().paths)
        remove_stubbornly(path);

    // End by the signal itself, so that the caller sees it.
    std::signal(signal, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    std::raise(signal);
}

}  // namespace

void remove_unfinished_output_on_signal()
{
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        sigaddset(&signals, signal);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::thread(wait_for_signal, signals).detach();
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

std::mutex& UnfinishedOutput::mutex()
{
    return unfinished().mutex;
}

void UnfinishedOutput::forget()
{
    unfinished().paths.erase(path_);
}

}  // namespace braidzone
