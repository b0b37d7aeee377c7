#pragma once

#include <stdexcept>
#include <string>

namespace braidzone {

/// Base of every error that a user can cause; `main` catches it once.
///
/// The class names who can repair it, the message says what was found (value and unit), where
/// (file and line, key, element index), and what is allowed.
class Error : public std::runtime_error {
public:
    Error(const std::string& message, int exit_status)
        : std::runtime_error(message), exit_status_(exit_status)
    {
    }
    /// Status with which the program ends: 2 to 5, see the derived classes.
    int exit_status() const { return exit_status_; }

private:
    int exit_status_;
};

/// The case file or the command line: unknown key, wrong unit, value out of range (status 2).
class ConfigError : public Error {
public:
    explicit ConfigError(const std::string& message) : Error(message, 2) {}
};

/// An input file or argument whose content cannot be used (status 3).
class InputError : public Error {
public:
    explicit InputError(const std::string& message) : Error(message, 3) {}
};

/// A shape that does not permit the task: open surface, device that does not fit (status 3).
class GeometryError : public Error {
public:
    explicit GeometryError(const std::string& message) : Error(message, 3) {}
};

/// An iteration that did not reach its criterion (status 4).
class ConvergenceError : public Error {
public:
    explicit ConvergenceError(const std::string& message) : Error(message, 4) {}
};

/// Reading or writing failed: missing file, no permission, no space (status 5).
class IoError : public Error {
public:
    explicit IoError(const std::string& message) : Error(message, 5) {}
};

}  // namespace braidzone
