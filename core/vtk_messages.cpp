#include "core/vtk_messages.hpp"

#include "core/error.hpp"

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <vector>

namespace braidzone {

namespace {

/// "ERROR: In File.cxx, line 12\nvtkReader (0x55d1): What happened\n\n" without all but the end.
std::string without_origin(std::string text)
{
    const std::size_t address = text.find("): ");
    if (address != std::string::npos) text.erase(0, address + 3);
    const std::size_t last = text.find_last_not_of(" \n");
    text.erase(last == std::string::npos ? 0 : last + 1);
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

class CollectingWindow : public vtkOutputWindow {
public:
    static CollectingWindow* New() { return new CollectingWindow; }

    // Errors, warnings and debug text all arrive here.
    void DisplayText(const char* text) override
    {
        messages.push_back(without_origin(text));
        if (!failure.empty()) throw IoError(failure + ": " + messages.back());
    }

    std::string failure;
    std::vector<std::string> messages;
};

}  // namespace

struct VtkMessages::Impl {
    vtkSmartPointer<vtkOutputWindow> former = vtkOutputWindow::GetInstance();
    vtkSmartPointer<CollectingWindow> window = vtkSmartPointer<CollectingWindow>::New();
    vtkLogger::Verbosity former_verbosity = vtkLogger::GetCurrentVerbosityCutoff();
};

VtkMessages::VtkMessages(const std::string& failure) : impl_(std::make_unique<Impl>())
{
    impl_->window->failure = failure;
    vtkOutputWindow::SetInstance(impl_->window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // it prints what the window gets
}

VtkMessages::~VtkMessages()
{
    vtkLogger::SetStderrVerbosity(impl_->former_verbosity);
    vtkOutputWindow::SetInstance(impl_->former);
}

bool VtkMessages::any() const
{
    return !impl_->window->messages.empty();
}

std::string VtkMessages::first() const
{
    return any() ? impl_->window->messages.front() : "";
}

}  // namespace braidzone
