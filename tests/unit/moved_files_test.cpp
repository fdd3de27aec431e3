// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/moved_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/expect_error.h"
#include "tests/support/image_files.h"

namespace {

namespace fs = std::filesystem;

class MovedFilesTest : public testing::Test {
  protected:
    void write(const std::string& name) {
        fs::create_directories(fs::path(folder / name).parent_path());
        test::writeBytes(folder / name, "x");
    }
    std::string full(const std::string& name) { return folder / name; }
    void writeProject() {
        test::writeBytes(folder / "p.patina",
                         R"({"photo": {"color": "shoot/c.png", "depth": "shoot/raw/d.exr", "segments": ""},
                             "environment": {"path": "light.exr"}, "back_depth": 7,
                             "segments": [{"edit": {"drives": {"alpha": {"mask": "p.masks/m.png"},
                                                               "albedo": {"source": "luminance"}}}}, 3]})");
    }

    test::TempFolder folder;
};

TEST_F(MovedFilesTest, MissingFilesAreThoseThatAreNeeded) {
    writeProject();
    write("light.exr");
    EXPECT_EQ(core::missingFiles(full("p.patina")),
              (std::vector<std::string>{full("shoot/c.png"), full("shoot/raw/d.exr"), full("p.masks/m.png")}));
    write("elsewhere.png");
    EXPECT_EQ(core::missingFiles(full("p.patina"), {{full("shoot/c.png"), full("elsewhere.png")}}).size(), 2U);
    test::writeBytes(folder / "broken.patina", "{");
    test::expectError(core::ErrorKind::Input, {}, [&] { (void)core::missingFiles(full("broken.patina")); });
}

TEST_F(MovedFilesTest, OthersAreFoundBesideOne) {
    const std::vector<std::string> missing{full("shoot/c.png"), full("shoot/raw/d.exr"), full("p.masks/m.png"),
                                           full("shoot/gone.png")};
    write("new/renamed.png");  // the photograph
    write("new/raw/d.exr");    // as before, in a folder beside it
    write("new/m.png");        // no folder any more
    const core::MovedFiles moved = core::filesBeside(missing, missing[0], full("new/renamed.png"));
    EXPECT_EQ(moved, (core::MovedFiles{{missing[0], full("new/renamed.png")},
                                       {missing[1], full("new/raw/d.exr")},
                                       {missing[2], full("new/m.png")}}));
    EXPECT_TRUE(core::filesBeside(missing, missing[0], full("nowhere/c.png")).empty());
}

}  // namespace
