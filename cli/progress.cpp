#include "cli/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace braidzone {
namespace {

/// Returns the cursor to the start of the line and clears it (ECMA-48, EL).
constexpr const char* clear_line = "\r\033[K";

}  // namespace

Progress::Progress(bool quiet) : shown_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress()
{
    if (shown_ && !stage_.empty()) std::fputs(clear_line, stderr);
}

void Progress::begin(const std::string& stage, const std::string& doing)
{
    end();
    stage_ = stage;
    begun_ = Clock::now();
    if (shown_) std::fprintf(stderr, "%s%s ...", clear_line, doing.c_str());
}

void Progress::end()
{
    if (stage_.empty()) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    const auto known = std::find_if(times_.begin(), times_.end(),
                                    [&](const StageTime& time) { return time.stage == stage_; });
    if (known != times_.end()) {
        known->seconds += seconds;
    } else {
        times_.push_back({stage_, seconds});
    }
    stage_.clear();
    if (shown_) std::fputs(clear_line, stderr);
}

double Progress::seconds(const std::string& stage) const
{
    for (const StageTime& time : times_) {
        if (time.stage == stage) return time.seconds;
    }
    return 0.0;
}

}  // namespace braidzone
