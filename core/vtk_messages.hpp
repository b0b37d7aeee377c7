#pragma once

#include <memory>
#include <string>

namespace braidzone {

/// Holds back what VTK would print while it reads or writes, so that it can go into our message.
///
/// VTK's readers report failure by text on stderr only. From construction to destruction errors
/// and warnings of all VTK objects are collected here. One at a time: VTK has one output window.
class VtkMessages {
public:
    /// @param failure  if not empty, the first message is thrown, as IoError "failure: message".
    ///                 Readers need it: some of VTK's go on after an error with a file that they
    ///                 have closed, and end the program.
    explicit VtkMessages(const std::string& failure = "");
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    bool any() const;
    /// The first message in one line, without VTK's file names and addresses.
    std::string first() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace braidzone
