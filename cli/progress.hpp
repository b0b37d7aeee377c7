#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace braidzone {

/// Wall time of one stage of a run.
struct StageTime {
    std::string stage;
    double seconds = 0.0;
};

/// Times the stages of a run and shows the current one on stderr, if that is a terminal.
class Progress {
public:
    /// @param quiet  show nothing
    explicit Progress(bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Ends the current stage, if any, and begins the next.
    /// @param stage   its name in the summary
    /// @param doing   what is shown, e.g. "deploying the device"
    void begin(const std::string& stage, const std::string& doing);
    /// Ends the last stage and clears the line.
    void end();

    /// Stages that have ended; a stage that was begun twice has one entry with the sum.
    const std::vector<StageTime>& times() const { return times_; }
    double seconds(const std::string& stage) const;

private:
    using Clock = std::chrono::steady_clock;
    bool shown_ = false;
    std::string stage_;
    Clock::time_point begun_;
    std::vector<StageTime> times_;
};

}  // namespace braidzone
