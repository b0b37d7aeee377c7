#pragma once

#include "discrepancy/diagnosis_problem.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace braidzone {

/// Residuals of simulations that were made, in a file: an interrupted diagnosis that is started
/// again finds them and does not simulate them twice. The result is the same to the last bit.
///
/// File: 8 bytes "bzresid1" and the key's 64; then a record for each simulation, its length
/// (uint64), a hash (FNV-1a, uint64), and, as uint64 and double of this machine: the number of
/// effects, of each its candidate, the number of values, the values; then the number of residuals
/// and them, or 0, the program's status for the error, and its text. A record that was not written
/// to its end, and what comes after it, is dropped.
class ResidualMemory {
public:
    /// Opens the file and reads what is there, if it is of the same key; else begins anew. While
    /// another process has the file open, and where it cannot be written, nothing is remembered.
    /// @param key  64 characters: a hash of all that the residuals depend on
    ResidualMemory(std::filesystem::path file, const std::string& key);
    ~ResidualMemory();  ///< the file stays, unless it holds nothing
    ResidualMemory(const ResidualMemory&) = delete;
    ResidualMemory& operator=(const ResidualMemory&) = delete;

    /// Simulations that an earlier run left.
    std::size_t num_found() const { return num_found_; }

    /// The problem with residuals that are looked up first, and kept. This must outlive it.
    DiagnosisProblem around(DiagnosisProblem problem);

    /// Removes the file: the diagnosis is done.
    void forget();

private:
    struct Outcome {
        Eigen::VectorXd residuals;  ///< empty if it failed
        int status = 0;
        std::string failure;
    };
    using Words = std::vector<std::uint64_t>;  ///< effects, as in the file

    static Words words_of(const std::vector<ActiveEffect>& effects);
    static std::string record_of(const Words& effects, const Outcome& outcome);
    bool read_record(const std::string& bytes, std::size_t& at);
    void read_all(const std::string& key);
    void keep(const Words& effects, const Outcome& outcome);

    std::filesystem::path file_;
    int descriptor_ = -1;
    std::size_t num_found_ = 0;
    std::mutex access_;
    std::map<Words, Outcome> known_;
};

}  // namespace braidzone
