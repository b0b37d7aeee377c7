#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace braidzone::test {

/// The built program, started with arguments; its output goes to files in `folder`.
class Program {
public:
    Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder)
        : out_(folder / "program.out"), err_(folder / "program.err")
    {
        std::vector<std::string> words = {BRAIDZONE_PROGRAM};
        words.insert(words.end(), arguments.begin(), arguments.end());
        process_ = ::fork();
        if (process_ < 0) throw std::runtime_error("fork failed");
        if (process_ == 0) {
            redirect(out_, STDOUT_FILENO);
            redirect(err_, STDERR_FILENO);
            std::vector<char*> argv;
            for (std::string& word : words)
                argv.push_back(word.data());
            argv.push_back(nullptr);
            ::execv(argv.front(), argv.data());
            ::_exit(127);
        }
    }

    void send(int signal) const { ::kill(process_, signal); }

    /// Waits for the end. Exit status, or 128 + signal as a shell reports it.
    int wait() const
    {
        int status = 0;
        ::waitpid(process_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

    std::string out() const { return text_of(out_); }
    std::string err() const { return text_of(err_); }

private:
    static void redirect(const std::filesystem::path& file, int descriptor)
    {
        const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        ::dup2(opened, descriptor);
    }
    static std::string text_of(const std::filesystem::path& file)
    {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return std::move(text).str();
    }

    std::filesystem::path out_, err_;
    pid_t process_ = -1;
};

}  // namespace braidzone::test
