#include "discrepancy/residual_memory.hpp"

#include "core/error.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <bit>
#include <cstring>
#include <string_view>
#include <utility>

namespace braidzone {
namespace {

constexpr std::string_view magic = "bzresid1";

/// Fowler, Noll and Vo's hash, 64 bits, variant 1a.
std::uint64_t fnv1a(std::string_view bytes)
{
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U;
    }
    return hash;
}

void append(std::string& bytes, std::uint64_t word)
{
    char raw[sizeof word];
    std::memcpy(raw, &word, sizeof word);
    bytes.append(raw, sizeof word);
}

/// Takes words off a text, one by one.
class WordReader {
public:
    explicit WordReader(std::string_view bytes) : bytes_(bytes) {}

    std::uint64_t next()
    {
        std::uint64_t word = 0;
        if (bytes_.size() < sizeof word) return 0;
        std::memcpy(&word, bytes_.data(), sizeof word);
        bytes_.remove_prefix(sizeof word);
        return word;
    }
    std::string_view rest() const { return bytes_; }

private:
    std::string_view bytes_;
};

std::string content_of(int descriptor)
{
    std::string bytes;
    char block[1 << 16];
    ::lseek(descriptor, 0, SEEK_SET);
    for (ssize_t got = 0; (got = ::read(descriptor, block, sizeof block)) > 0;)
        bytes.append(block, static_cast<std::size_t>(got));
    return bytes;
}

}  // namespace

ResidualMemory::ResidualMemory(std::filesystem::path file, const std::string& key)
    : file_(std::move(file))
{
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) return;
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
        ::close(descriptor_);
        descriptor_ = -1;
        return;
    }
    read_all(key);
}

ResidualMemory::~ResidualMemory()
{
    if (known_.empty()) forget();
    if (descriptor_ >= 0) ::close(descriptor_);
}

void ResidualMemory::forget()
{
    if (descriptor_ < 0) return;
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
    ::close(descriptor_);
    descriptor_ = -1;
}

void ResidualMemory::read_all(const std::string& key)
{
    const std::string bytes = content_of(descriptor_);
    const std::string head = std::string(magic) + key;
    std::size_t good = 0;
    if (bytes.substr(0, head.size()) == head) {
        good = head.size();
        while (read_record(bytes, good)) {
        }
        num_found_ = known_.size();
    }
    const bool is_new = good == 0;
    bool ready = ::ftruncate(descriptor_, static_cast<off_t>(good)) == 0 &&
                 ::lseek(descriptor_, 0, SEEK_END) >= 0;
    if (ready && is_new)
        ready = ::write(descriptor_, head.data(), head.size()) == static_cast<ssize_t>(head.size());
    if (ready) return;
    ::close(descriptor_);
    descriptor_ = -1;
}

bool ResidualMemory::read_record(const std::string& bytes, std::size_t& at)
{
    const std::string_view left = std::string_view(bytes).substr(at);
    WordReader reader(left);
    const std::uint64_t length = reader.next(), hash = reader.next();
    if (length == 0 || reader.rest().size() < length) return false;
    const std::string_view payload = reader.rest().substr(0, length);
    if (fnv1a(payload) != hash) return false;
    WordReader words(payload);
    Words effects = {words.next()};
    for (std::uint64_t effect = 0; effect < effects.front(); ++effect) {
        effects.push_back(words.next());
        effects.push_back(words.next());
        const std::uint64_t num_values = effects.back();
        for (std::uint64_t i = 0; i < num_values; ++i)
            effects.push_back(words.next());
    }
    Outcome outcome;
    outcome.residuals.resize(static_cast<Eigen::Index>(words.next()));
    for (double& value : outcome.residuals)
        value = std::bit_cast<double>(words.next());
    if (outcome.residuals.size() == 0) {
        outcome.status = static_cast<int>(words.next());
        outcome.failure = words.rest();
    }
    known_.emplace(std::move(effects), std::move(outcome));
    at += 2 * sizeof length + length;
    return true;
}

ResidualMemory::Words ResidualMemory::words_of(const std::vector<ActiveEffect>& effects)
{
    Words words = {effects.size()};
    for (const ActiveEffect& effect : effects) {
        words.push_back(effect.candidate);
        words.push_back(effect.values.size());
        for (const double value : effect.values)
            words.push_back(std::bit_cast<std::uint64_t>(value));
    }
    return words;
}

std::string ResidualMemory::record_of(const Words& effects, const Outcome& outcome)
{
    std::string payload;
    for (const std::uint64_t word : effects)
        append(payload, word);
    append(payload, static_cast<std::uint64_t>(outcome.residuals.size()));
    for (const double value : outcome.residuals)
        append(payload, std::bit_cast<std::uint64_t>(value));
    if (outcome.residuals.size() == 0) {
        append(payload, static_cast<std::uint64_t>(outcome.status));
        payload += outcome.failure;
    }
    std::string record;
    append(record, payload.size());
    append(record, fnv1a(payload));
    return record + payload;
}

void ResidualMemory::keep(const Words& effects, const Outcome& outcome)
{
    const std::scoped_lock lock(access_);
    if (!known_.emplace(effects, outcome).second || descriptor_ < 0) return;
    const std::string record = record_of(effects, outcome);
    if (::write(descriptor_, record.data(), record.size()) == static_cast<ssize_t>(record.size()))
        return;
    // A full disk: what is there stays good, and nothing is added behind a torn record.
    ::close(descriptor_);
    descriptor_ = -1;
}

DiagnosisProblem ResidualMemory::around(DiagnosisProblem problem)
{
    problem.residuals = [this, simulated = std::move(problem.residuals)](
                            const std::vector<ActiveEffect>& effects) -> Eigen::VectorXd {
        const Words words = words_of(effects);
        const Outcome* found = nullptr;
        {
            const std::scoped_lock lock(access_);
            const auto place = known_.find(words);
            if (place != known_.end()) found = &place->second;
        }
        if (found != nullptr && found->residuals.size() > 0) return found->residuals;
        if (found != nullptr) throw Error(found->failure, found->status);
        Outcome outcome;
        try {
            outcome.residuals = simulated(effects);
        } catch (const Error& error) {
            outcome.status = error.exit_status();
            outcome.failure = error.what();
            keep(words, outcome);
            throw;
        }
        keep(words, outcome);
        return outcome.residuals;
    };
    return problem;
}

}  // namespace braidzone
