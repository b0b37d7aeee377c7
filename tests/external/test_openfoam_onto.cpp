// `export --onto` stopped at any moment, and on full disks: the case is as it was or has the device
// whole, and OpenFOAM takes it.

#include "core/surface_io.hpp"
#include "export/foam_update.hpp"
#include "external/foam_box_case.hpp"
#include "external/openfoam.hpp"
#include "support/foam_box.hpp"
#include "support/folder_contents.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <random>
#include <thread>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
using Contents = std::map<std::string, std::string>;

const fs::path sidewall = BRAIDZONE_SOURCE_DIR "/cases/sidewall_aneurysm";

/// The case of a box about the sidewall aneurysm, to which its device has been applied.
class OpenFoamOnto : public testing::Test {
protected:
    void SetUp() override
    {
        if (!test::has_openfoam()) GTEST_SKIP() << "simpleFoam is not installed";
        write_case(foam_);
        ASSERT_EQ(apply("1.0").wait(), 0) << test::file_text(logs_.path() / "program.err");
        before_ = test::folder_contents(foam_);
        const fs::path other = cases_.path() / "other";
        fs::copy(foam_, other, fs::copy_options::recursive);
        const auto start = std::chrono::steady_clock::now();
        ASSERT_EQ(apply("3.0", other).wait(), 0);
        duration_ = std::chrono::steady_clock::now() - start;
        after_ = test::folder_contents(other);
        ASSERT_NE(before_, after_);
    }

    static void write_case(const fs::path& folder)
    {
        constexpr double cell = 0.6e-3;
        const Box box = bounding_box(read_surface(sidewall / "vessel.stl", {}));
        std::array<int, 3> size = {};
        for (int axis = 0; axis < 3; ++axis)
            size[static_cast<std::size_t>(axis)] =
                static_cast<int>((box.upper - box.lower)[axis] / cell) + 3;
        const FoamMesh mesh = test::foam_box(size, cell, box.lower - Vec3::Constant(cell));
        const double inlet_area = size[1] * size[2] * cell * cell;
        test::write_box_case(
            folder, mesh,
            {{.name = "inlet", .area = inlet_area}, {.name = "outlet", .area = inlet_area}}, {},
            Fluid{});
    }

    /// Applies the device with another resistance along the sheet.
    test::Program apply(const std::string& tangential_ratio, const fs::path& folder) const
    {
        return test::Program(
            {"export", (sidewall / "case.toml").string(), "--onto", folder.string(), "--quiet",
             "--set", "porous.tangential_ratio=" + tangential_ratio},
            logs_.path());
    }
    test::Program apply(const std::string& tangential_ratio) const
    {
        return apply(tangential_ratio, foam_);
    }

    void put_back()
    {
        fs::remove_all(foam_);
        for (const auto& [name, text] : before_) {
            if (text == "folder")
                fs::create_directories(foam_ / name);
            else
                write_text_file(foam_ / name, text);
        }
    }

    /// OpenFOAM's own check of the mesh and its zones, and one iteration with the device.
    static bool is_solved(const fs::path& folder)
    {
        return test::run_in(folder,
                            "sed -i -e 's/^endTime .*/endTime 1;/' "
                            "-e 's/^writeInterval .*/writeInterval 1;/' system/controlDict",
                            "log.sed") &&
               test::run_in(folder, "checkMesh", "log.checkMesh") &&
               test::file_text(folder / "log.checkMesh").find("Mesh OK") != std::string::npos &&
               test::run_in(folder, "simpleFoam", "log.simpleFoam") &&
               fs::exists(folder / "1" / "U");
    }

    test::TemporaryFolder cases_, logs_;
    fs::path foam_ = cases_.path() / "foam";
    Contents before_, after_;
    std::chrono::duration<double> duration_ = {};
};

// 100 signals at random moments of a call. INT, TERM and HUP leave the old or the new state; so
// does KILL, if not at once then as soon as the next call finds what is left.
TEST_F(OpenFoamOnto, IsAllOrNothingUnderAHundredSignals)
{
    std::mt19937 random(20);
    std::uniform_real_distribution<double> share(0.0, 1.05);
    int num_old = 0, num_new = 0, num_restored = 0;
    for (int i = 0; i < 100; ++i) {
        constexpr std::array signals = {SIGKILL, SIGINT, SIGKILL, SIGTERM, SIGKILL, SIGHUP};
        const int signal = signals[static_cast<std::size_t>(i) % signals.size()];
        const test::Program program = apply("3.0");
        std::this_thread::sleep_for(share(random) * duration_);
        program.send(signal);
        program.wait();
        Contents found = test::folder_contents(foam_);
        if (found != before_ && found != after_) {
            EXPECT_EQ(signal, SIGKILL) << "the state is neither the old nor the new one";
            ++num_restored;
            restore_foam_case(foam_);
            found = test::folder_contents(foam_);
        }
        ASSERT_TRUE(found == before_ || found == after_) << "after signal " << signal;
        ++(found == before_ ? num_old : num_new);
        if (found == after_) put_back();
    }
    std::printf("%d old, %d new, %d of them with leftovers of a kill\n", num_old, num_new,
                num_restored);
    EXPECT_GT(num_old, 0);
    EXPECT_TRUE(is_solved(foam_));
}

// A case whose change was cut short has no constant/fdPorosity: no solver runs without the device.
TEST_F(OpenFoamOnto, IsNotSolvedWithoutItsKeyFile)
{
    fs::remove(foam_ / "constant/fdPorosity");
    const std::string command = "cd '" + foam_.string() +
                                "' && WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam} "
                                "simpleFoam > log.simpleFoam 2>&1";
    EXPECT_NE(std::system(command.c_str()), 0);
    EXPECT_NE(test::file_text(foam_ / "log.simpleFoam").find("fdPorosity"), std::string::npos);
}

// Each file may be as large as the limit, no larger: that fails at another file each time.
TEST_F(OpenFoamOnto, IsAsBeforeIfAFileBecomesTooLarge)
{
    rlimit old_limit = {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
    std::size_t largest = 0;
    for (const auto& [name, text] : after_)
        largest = std::max(largest, before_[name] == text ? 0 : text.size());
    for (const double share : {0.0, 0.01, 0.1, 0.3, 0.6, 0.99}) {
        rlimit limit = old_limit;
        limit.rlim_cur = static_cast<rlim_t>(share * static_cast<double>(largest));
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
        const test::Program program = apply("3.0");
        const int status = program.wait();
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
        EXPECT_EQ(status, 5) << limit.rlim_cur;
        EXPECT_EQ(test::folder_contents(foam_), before_) << limit.rlim_cur;
    }
    EXPECT_TRUE(is_solved(foam_));
}

/// A file system in memory that holds so many bytes, as long as this object lives.
class SmallDisk {
public:
    SmallDisk(const fs::path& place, std::size_t size) : place_(place)
    {
        fs::create_directories(place);
        const std::string options = "size=" + std::to_string(size);
        is_mounted_ = ::mount("tmpfs", place.c_str(), "tmpfs", 0,
                              static_cast<const void*>(options.c_str())) == 0;
    }
    ~SmallDisk()
    {
        if (is_mounted_) ::umount2(place_.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    bool is_mounted() const { return is_mounted_; }

private:
    fs::path place_;
    bool is_mounted_ = false;
};

// The disk holds the case and a part of what is to be written beside it.
TEST_F(OpenFoamOnto, IsAsBeforeIfTheDiskIsFull)
{
    std::size_t case_size = 0, fresh_size = 0;
    constexpr std::size_t page = 4096;
    for (const auto& [name, text] : before_)
        case_size += (text.size() / page + 1) * page;
    for (const auto& [name, text] : after_) {
        if (before_[name] != text) fresh_size += (text.size() / page + 1) * page;
    }
    for (const double share : {0.05, 0.3, 0.6, 0.9}) {
        const SmallDisk disk(
            cases_.path() / "disk",
            case_size + static_cast<std::size_t>(share * static_cast<double>(fresh_size)));
        if (!disk.is_mounted()) GTEST_SKIP() << "no file system may be mounted here";
        const fs::path foam = cases_.path() / "disk" / "foam";
        fs::copy(foam_, foam, fs::copy_options::recursive);
        EXPECT_EQ(apply("3.0", foam).wait(), 5) << share;
        EXPECT_EQ(test::folder_contents(foam), before_) << share;
    }
}

}  // namespace
}  // namespace braidzone
