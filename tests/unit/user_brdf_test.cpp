// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/user_brdf.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/io/material_json.h"
#include "core/io/project.h"
#include "core/material/brdf_file.h"
#include "core/shading/reference_renderer.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"
#include "tests/support/user_brdf_text.h"

namespace core {
namespace {

using test::evaluating;
using test::expectError;
using test::kMattBrdf;
using testing::HasSubstr;

void refused(const std::string& text, int line, const std::string& reason) {
    SCOPED_TRACE(text.substr(0, 200));
    expectError(ErrorKind::Input, {"a.brdf.glsl:" + std::to_string(line) + ": ", reason},
                [&] { static_cast<void>(parseUserBrdf("a.brdf.glsl", text)); });
}

std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
}

TEST(UserBrdf, DeclaresParametersWithRangesLabelsAndUnits) {
    const auto brdf = parseUserBrdf("a.brdf.glsl",
                                    "uniform float gloss = 0.5;  // 0.01 to 1, log, \"How glossy\"\n"
                                    "uniform float turn = -1.5;//-90 to 90 °\n"
                                    "uniform float thickness = 3e2f;  // 0 to 1000 nm, \"Film\"\n" +
                                        kMattBrdf);
    ASSERT_EQ(brdf->params.size(), 3u);
    EXPECT_STREQ(brdf->params[0].key, "gloss");
    EXPECT_STREQ(brdf->params[0].label, "How glossy");
    EXPECT_STREQ(brdf->params[0].unit, "");
    EXPECT_EQ(brdf->params[0].min, 0.01f);
    EXPECT_EQ(brdf->params[0].max, 1);
    EXPECT_EQ(brdf->params[0].initial, 0.5f);
    EXPECT_TRUE(brdf->params[0].logScale);
    EXPECT_STREQ(brdf->params[1].label, "turn");
    EXPECT_STREQ(brdf->params[1].unit, "°");
    EXPECT_EQ(brdf->params[1].initial, -1.5f);
    EXPECT_FALSE(brdf->params[1].logScale);
    EXPECT_STREQ(brdf->params[2].unit, "nm");
    EXPECT_EQ(brdf->params[2].initial, 300);
    EXPECT_TRUE(brdf->usesAlbedo);
    EXPECT_FALSE(brdf->usesSpecular);
    EXPECT_EQ(brdf->evaluateLine, 5);
    EXPECT_EQ(brdf->sampleLine, 7);
}

TEST(UserBrdf, KeepsLinesAndMakesNamesItsOwn) {
    const auto brdf =
        parseUserBrdf("a.brdf.glsl", "// one\n/* two\nthree */ const float driveValues = 0.1;\n" + kMattBrdf +
                                         "float gl_Position(float main) { return main * driveValues; }");
    std::vector<std::string> lines;
    std::istringstream stream(brdf->code);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 8u);
    EXPECT_EQ(lines[2], "const float user@ndriveValues = 0.1 ; ");
    EXPECT_EQ(lines[3], "");
    EXPECT_THAT(lines[4], HasSubstr("return user@nalbedo * kInvPi ;"));
    EXPECT_EQ(lines[7], "float user@ngl_Position ( float user@nmain ) { return user@nmain * user@ndriveValues ; } ");
}

TEST(UserBrdf, CountsTheStepsOfLoopsAndKeepsIndicesInside) {
    const auto brdf = parseUserBrdf("a.brdf.glsl",
                                    evaluating("float a[3]; for (int i = 0; i < 3; ++i) a[i] = 0.1; for (;;) { break; }"
                                               " while (a[0] > 1.0) {} return albedo * a[2];"));
    EXPECT_THAT(brdf->code, HasSubstr("for ( int user@ni = 0 ; user_step() && (user@ni < 3 ) ; ++ user@ni )"));
    EXPECT_THAT(brdf->code, HasSubstr("user@na [ user_index(user@ni , user@na.length()) ] = 0.1"));
    EXPECT_THAT(brdf->code, HasSubstr("for ( ; user_step() ; )"));
    EXPECT_THAT(brdf->code, HasSubstr("while ( user_step() && (user@na [ 0 ] > 1.0 ) )"));
    EXPECT_THAT(brdf->code, HasSubstr("* user@na [ 2 ]"));
}

TEST(UserBrdf, OfAnotherTextHasAnotherRevision) {
    const std::string other = evaluating("return albedo * 0.3;");
    EXPECT_NE(parseUserBrdf("a", kMattBrdf)->revision, parseUserBrdf("a", other)->revision);
    EXPECT_EQ(parseUserBrdf("a", kMattBrdf)->revision, parseUserBrdf("b", kMattBrdf)->revision);
}

TEST(UserBrdf, WithAWrongParameterIsRefused) {
    const auto param = [](const std::string& declaration) { return "\n" + declaration + "\n" + kMattBrdf; };
    refused(param("uniform float a = 0.5;"), 2, "range of \"a\" is missing");
    refused(param("uniform float a = 0.5; // 0 - 1"), 2, "range of \"a\" is missing");
    refused(param("uniform float a = 5.0; // 0 to 1"), 2, "contain its initial value");
    refused(param("uniform float a = 0.5; // 1 to 0"), 2, "has to rise");
    refused(param("uniform float a = 0.0; // 0 to 1, log"), 2, "above 0");
    refused(param("uniform float a = 0.5; // nan to 1"), 2, "\"nan\" is no number");
    refused(param("uniform float a = 1e99; // 0 to 1e99"), 2, "\"1e99\" is no number");
    refused(param("uniform float a = 0.5; // 0 to 1, quick"), 2, "\"quick\" is not understood");
    refused(param("uniform float a = 0.5; // 0 to 1, \"A"), 2, "closing quote");
    refused(param("uniform vec3 tint;"), 2, "A parameter is declared as");
    refused(param("uniform sampler2D t;"), 2, "not allowed");
    refused(param("uniform float a"), 2, "declared in one line");
    refused(param("uniform float blend = 0.5; // 0 to 1"), 2, "edits have that key already");
    refused(param("uniform float max = 0.5; // 0 to 1"), 2, "a name of GLSL");
    refused(param("uniform float a = 0.5; // 0 to 1\nuniform float a = 0.5; // 0 to 1"), 3, "declared twice");
    std::string many;
    for (int i = 0; i < 13; ++i) many += "uniform float a" + std::to_string(i) + " = 0.5; // 0 to 1\n";
    refused(many + kMattBrdf, 13, "at most 12 parameters");
}

TEST(UserBrdf, WithoutItsFunctionsIsRefused) {
    refused("// nothing\n", 1, "lacks the function vec3 evaluate(vec3 wo, vec3 wi)");
    refused(test::replaced(kMattBrdf, "vec3 sample", "vec3 sampel"), 1, "lacks the function vec3 sample");
    refused(test::replaced(kMattBrdf, "vec2 u", "vec3 u"), 4, "has to be vec3 sample(vec3 wo, vec2 u)");
    refused(evaluating("return fresnel(wi.z);"), 2, "needs uniform vec3 specular");
}

TEST(UserBrdf, ReachesNothingButItsOwn) {
    refused("#define evaluate x\n" + kMattBrdf, 1, "no #include, #define");
    refused(kMattBrdf + "#include \"/etc/passwd\"\n", 5, "no #include");
    refused("\\\n" + kMattBrdf, 1, "The sign \\");
    refused("layout(binding = 0) buffer B { float x[]; };\n" + kMattBrdf, 1, "\"layout\" is not allowed");
    refused("struct A { float x; };\n" + kMattBrdf, 1, "\"struct\"");
    refused("float x = 1.0;\n" + kMattBrdf, 1, "have to be const");
    refused("float max(float a, float b) { return a; }\n" + kMattBrdf, 1, "\"max\" is a name of GLSL");
    refused("const float a = min(1.0, 2.0), luminance = 2.0;\n" + kMattBrdf, 1, "\"luminance\" is a name");
    refused(evaluating("return shading[0].brdf.albedo.rgb;"), 2, "no field \"brdf\"");
    refused(evaluating("switch (1) { default: break; } return albedo;"), 2, "\"switch\"");
    refused(evaluating("int a = 5 % 0; return albedo;"), 2, "There is no %");
    refused(evaluating("double a = 1.0lf; return albedo;"), 2, "is no int, uint or float");
}

TEST(UserBrdf, ThatWouldNotEndOrGrowIsRefused) {
    refused("vec3 f(vec3 a) { return f(a); }\n" + evaluating("return f(wi);"), 1, "calls itself");
    refused("float g(float a);\nfloat f(float a) { return g(a); }\nfloat g(float a) { return f(a); }\n" + kMattBrdf, 2,
            "calls itself");
    refused(evaluating("return evaluate(wi, wo);"), 2, "calls itself");
    std::string bomb = "float f0(float x) { return sin(x); }\n";
    for (int i = 1; i < 20; ++i) {
        const std::string call = "f" + std::to_string(i - 1) + "(x)";
        bomb += "float f" + std::to_string(i) + "(float x) { return " + call + "+" + call + "+" + call + "; }\n";
    }
    refused(bomb + kMattBrdf, 6, "is too long with all that it calls");
    refused(evaluating("float a[65]; return albedo;"), 2, "expected at most 64");
    refused(evaluating("float a[99999999999999999999]; return albedo;"), 2, "expected at most 64");
    refused(evaluating("float a[077]; return albedo;"), 2, "or no number");
    refused("const int n = 1000000;\n" + evaluating("float a[n]; return albedo;"), 3, "has to be a number");
    refused(evaluating("float a[8][8]; return albedo;"), 2, "Only a name can be indexed");
    refused(evaluating("float[8] a[8]; return albedo;"), 2, "without arrays in it");
    refused(evaluating("mat4 a[64]; mat4 b[64]; mat4 c[64]; mat4 d[64]; mat4 e[64]; return albedo;"), 2,
            "too many large arrays");
}

TEST(UserBrdf, OfAnyShapeIsReadOrRefused) {
    refused(kMattBrdf + "/* to the end", 5, "comment does not end");
    refused(kMattBrdf + "}", 5, "no bracket that this \"}\" closes");
    refused("((" + kMattBrdf, 1, "is not closed");
    refused(evaluating("return albedo * " + repeated("(", 50) + "1.0" + repeated(")", 50) + ";"), 2, "too deeply");
    refused(evaluating("return albedo * (0.1" + repeated("+0.1", 1000) + ");"), 2, "statement is too long");
    refused(kMattBrdf + repeated(";", 7000), 5, "more than 6000");
    refused(evaluating("float " + std::string(100, 'a') + "; return albedo;"), 2, "more than 64 characters");
    refused(evaluating(repeated("if (wi.z > 2.0) {} else ", 200) + "; return albedo;"), 2, "too many \"else\"");
    refused(std::string(100, '\0'), 1, "no text in UTF-8");
    refused("\xff\xfe" + kMattBrdf, 1, "no text in UTF-8");
    refused("// \xc3\n" + kMattBrdf, 1, "no text in UTF-8");
    for (const char* text :
         {"uniform", "const", "vec3", "vec3 f", "vec3 f(", "for", "\n", "float a[", ";", "const float a"})
        EXPECT_THROW(static_cast<void>(parseUserBrdf("a", text)), Error) << text;
    // Cut off anywhere.
    for (std::size_t size = 0; size + 2 < kMattBrdf.size(); ++size)
        EXPECT_THROW(static_cast<void>(parseUserBrdf("a", kMattBrdf.substr(0, size))), Error) << size;
    EXPECT_NO_THROW(static_cast<void>(parseUserBrdf("a", "\xef\xbb\xbf" + kMattBrdf)));
    EXPECT_NO_THROW(static_cast<void>(parseUserBrdf("a", test::replaced(kMattBrdf, ";\n", ";\r\n"))));
}

class UserBrdfFile : public testing::Test {
  protected:
    void write(const std::string& text) const { test::writeBytes(path_, text); }
    test::TempFolder folder_;
    std::string path_ = folder_ / "glossy.brdf.glsl";
};

TEST_F(UserBrdfFile, TooLargeOrEmptyIsRefused) {
    write(std::string(kMaxUserBrdfBytes + 1, ' '));
    expectError(ErrorKind::Input, {"glossy.brdf.glsl", "65537 bytes", "at most 65536"},
                [&] { static_cast<void>(loadBrdfFile(path_)); });
    write("");
    expectError(ErrorKind::Input, {"glossy.brdf.glsl", "empty"}, [&] { static_cast<void>(loadBrdfFile(path_)); });
}

TEST_F(UserBrdfFile, IsCheckedWhenLoaded) {
    write(kMattBrdf);
    int checks = 0;
    setUserBrdfCheck([&](const std::shared_ptr<const BrdfFile>& file) {
        ++checks;
        throw Error(ErrorKind::Input, file->path + ":3: no.");
    });
    EXPECT_THROW(static_cast<void>(loadBrdfFile(path_)), Error);
    EXPECT_EQ(loadBrdfFileOrProblem(path_)->problem, path_ + ":3: no.");
    setUserBrdfCheck({});
    EXPECT_EQ(checks, 2);
    EXPECT_TRUE(loadBrdfFile(path_)->problem.empty());
}

TEST_F(UserBrdfFile, IsNamedByEditsWithItsParameters) {
    write("uniform float gloss = 0.5;  // 0 to 1\n" + kMattBrdf);
    const Material m = materialFromJson(R"({"brdf": "file:)" + path_ + R"(", "gloss": 0.75})");
    EXPECT_EQ(m.values[0], 0.75f);
    EXPECT_EQ(materialFromJson(materialToJson(m)), m);
    EXPECT_EQ(materialFromJson(R"({"brdf": "file:)" + path_ + R"("})").values[0], 0.5f);
    expectError(ErrorKind::Usage, {"gloss", "[0, 1]"},
                [&] { static_cast<void>(materialFromJson(R"({"brdf": "file:)" + path_ + R"(", "gloss": 2})")); });
    expectError(ErrorKind::Usage, {"alpha", "\"gloss\""},
                [&] { static_cast<void>(materialFromJson(R"({"brdf": "file:)" + path_ + R"(", "alpha": 2})")); });
}

TEST_F(UserBrdfFile, ThatIsMissingKeepsTheEditsNumbersAndDrives) {
    write("uniform float gloss = 0.5;  // 0 to 1\nuniform float depth = 2.0;  // 0 to 9\n" + kMattBrdf);
    std::filesystem::copy(PATINA_SAMPLES "/studio", folder_ / "studio", std::filesystem::copy_options::recursive);
    const std::string project = folder_ / "studio/studio.patina";
    Scene scene = loadProject(project);
    Material m = fileMaterial(loadBrdfFile(path_));
    m.values = {0.25f, 7};
    Drive drive;
    drive.parameter = "gloss";
    drive.source = DriveSource::Luminance;
    m.drives.push_back(drive);
    scene.segments[0].edit = m;
    saveProject(scene, project);
    const std::string saved = test::readBytes(project);
    EXPECT_THAT(saved, HasSubstr("\"file:../glossy.brdf.glsl\""));

    std::filesystem::rename(path_, folder_ / "elsewhere");
    core::Notes notes;
    Scene without = loadProject(project, &notes);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_THAT(notes[0].english(), testing::AllOf(HasSubstr("glossy.brdf.glsl"), HasSubstr("does not exist")));
    EXPECT_FALSE(usable(*without.segments[0].edit));
    without.segments[0].name = "renamed";
    saveProject(without, project);
    without.segments[0].name = scene.segments[0].name;
    saveProject(without, project);
    EXPECT_EQ(nlohmann::json::parse(test::readBytes(project)), nlohmann::json::parse(saved));

    std::filesystem::rename(folder_ / "elsewhere", path_);
    EXPECT_EQ(loadProject(project).segments[0].edit->values, m.values);
    EXPECT_EQ(loadProject(project).segments[0].edit->drives, m.drives);
    EXPECT_EQ(withReloadedFile(*without.segments[0].edit, loadBrdfFile(path_)).values, m.values);
}

TEST_F(UserBrdfFile, ReloadedKeepsValuesByKey) {
    write("uniform float gloss = 0.5;  // 0 to 1\nuniform float depth = 2.0;  // 0 to 9\n" + kMattBrdf);
    Material m = fileMaterial(loadBrdfFile(path_));
    m.values = {0.25f, 7};
    write("uniform float fresh = 0.1;  // 0 to 1\nuniform float depth = 2.0;  // 0 to 5\n" + kMattBrdf);
    const Material reloaded = withReloadedFile(m, loadBrdfFile(path_));
    EXPECT_EQ(reloaded.values[0], 0.1f);
    EXPECT_EQ(reloaded.values[1], 5);
}

TEST_F(UserBrdfFile, IsNotForTheReferenceRenderer) {
    write(kMattBrdf);
    Scene scene = loadProject(PATINA_SAMPLES "/studio/studio.patina");
    scene.segments[0].edit = fileMaterial(loadBrdfFile(path_));
    auto analysis = std::make_shared<Analysis>();
    analysis->layers = std::make_shared<DepthLayers>();
    expectError(ErrorKind::Usage, {"glossy.brdf.glsl", "graphics device"},
                [&] { static_cast<void>(ReferenceRenderer(scene, analysis)); });
}

}  // namespace
}  // namespace core
