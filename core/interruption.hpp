#pragma once

#include <filesystem>
#include <mutex>

namespace braidzone {

/// Makes SIGINT, SIGTERM and SIGHUP remove unfinished output before they end the program.
///
/// A thread of its own waits for them, since nothing that removes folders may be called in a signal
/// handler. SIGHUP stays ignored if it is (nohup). SIGXFSZ is ignored: a file larger than the limit
/// (ulimit -f) then is an error of writing, as a full disk is. Call it once.
/// @throws std::runtime_error if the system has no pipe left
void remove_unfinished_output_on_signal();

/// An unfinished file or folder: removed with this object, or by a signal, unless it was finished.
class UnfinishedOutput {
public:
    explicit UnfinishedOutput(std::filesystem::path path);
    ~UnfinishedOutput();
    UnfinishedOutput(const UnfinishedOutput&) = delete;
    UnfinishedOutput& operator=(const UnfinishedOutput&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Moves the output to its place by `move`, which no signal interrupts; from then on it stays.
    template <typename Move>
    void finish(const Move& move)
    {
        without_signals([&] {
            move();
            forget();
        });
    }

    /// Does something that no signal interrupts: such as to make a folder and to register it here,
    /// so that there is no moment at which it is there and would be left.
    template <typename Action>
    static auto without_signals(const Action& action)
    {
        const std::scoped_lock no_signal(mutex());
        return action();
    }

    /// From now on it stays whatever happens. To be called in `finish` only.
    void forget();

private:
    static std::recursive_mutex& mutex();
    std::filesystem::path path_;
};

}  // namespace braidzone
