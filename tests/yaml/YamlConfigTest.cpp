#include "yaml/YamlConfig.h"

#include <gtest/gtest.h>

namespace mrpp
{

namespace
{

std::string complaintAbout(std::string_view text)
{
    try
    {
        return "read: " + parseYaml(text, "p").canonical();
    }
    catch (const PlanError &error)
    {
        return error.what();
    }
}

TEST(YamlConfig, everyNodeKnowsItsPlace)
{
    const Config root = parseYaml("a: 1\nb:\n  - 2\n  - {c: three}\n", "plan.yaml");
    ASSERT_TRUE(root.isMap());
    EXPECT_EQ(root.where().toString(), "plan.yaml:1:1");
    const Config::Entry &b = root.entries()[1];
    EXPECT_EQ(b.where.toString(), "plan.yaml:2:1");
    EXPECT_EQ(b.value.where().toString(), "plan.yaml:3:3");
    EXPECT_EQ(b.value.items()[0].where().toString(), "plan.yaml:3:5");
    const Config::Entry &c = b.value.items()[1].entries()[0];
    EXPECT_EQ(c.where.toString(), "plan.yaml:4:6");
    EXPECT_EQ(c.value.where().toString(), "plan.yaml:4:9");
    EXPECT_EQ(c.value.text(), "three");
}

TEST(YamlConfig, aByteOrderMarkShiftsNothing)
{
    EXPECT_EQ(parseYaml("\xEF\xBB\xBF"
                        "a: 1",
                        "p")
                  .entries()[0]
                  .value.where()
                  .toString(),
              "p:1:4");
}

TEST(YamlConfig, columnsCountBytes)
{
    EXPECT_EQ(complaintAbout("ä: é\nüb: {ß: 1, ß: 2}"),
              "p:2:14: the key 'ß' stands here a second time (first in line 2); keep one of the two");
}

TEST(YamlConfig, emptyTextsGiveAnEmptyNode)
{
    for (const char *text : {"", "# nothing\n", "---\n", "\n\n"})
        EXPECT_EQ(parseYaml(text, "p").kind(), Config::Kind::empty) << text;
}

TEST(YamlConfig, quotedDigitsStayText)
{
    EXPECT_EQ(parseYaml("a: \"010\"", "p").find("a")->text(), "010");
    EXPECT_EQ(parseYaml("a: 007.map", "p").find("a")->text(), "007.map");
    EXPECT_EQ(parseYaml("a: 0.5", "p").find("a")->text(), "0.5");
    EXPECT_EQ(parseYaml("a: 0", "p").find("a")->text(), "0");
}

TEST(YamlConfig, windowsLinesAndFinalDotsAreTaken)
{
    EXPECT_EQ(parseYaml("a: 1\r\nb: 2\r\n...\r\n", "p").canonical(), R"({"a":"1","b":"2"})");
}

struct BadYaml
{
    const char *text;
    const char *message;
};

class YamlConfigRefuses : public ::testing::TestWithParam<BadYaml>
{};

TEST_P(YamlConfigRefuses, withThePlace)
{
    const std::string complaint = complaintAbout(GetParam().text);
    EXPECT_EQ(complaint.substr(0, std::string(GetParam().message).size()), GetParam().message) << complaint;
}

INSTANTIATE_TEST_SUITE_P(
    all, YamlConfigRefuses,
    ::testing::Values(BadYaml{"a: 1\na: 2", "p:2:1: the key 'a' stands here a second time (first in line 1)"},
                      BadYaml{"{a: 1, a: 2}", "p:1:8: the key 'a' stands here a second time"},
                      BadYaml{"a: 1\n---\nb: 2", "p:2:1: a second YAML document"},
                      BadYaml{"a: 1\n---\n", "p:2:1: a second YAML document"},
                      BadYaml{"a: &x 1\nb: *x", "p:1:4: anchors"}, BadYaml{"a: &x {b: 1}", "p:1:4: anchors"},
                      BadYaml{"a: *x", "p:1:4: this is no YAML: the referenced anchor is not defined"},
                      BadYaml{"a: 1\n<<: {b: 1}", "p:2:1: merge keys"}, BadYaml{"a: !!str 5", "p:1:4: tags"},
                      BadYaml{"a: !mine {b: 1}", "p:1:4: tags"},
                      BadYaml{"a: 010", "p:1:4: '010' may be read as an octal"},
                      BadYaml{"a: [1, -007]", "p:1:8: '-007' may be read as an octal"},
                      BadYaml{"a: 0x1F", "p:1:4: '0x1F' may be read"},
                      BadYaml{"a: 0o17", "p:1:4: '0o17' may be read"},
                      BadYaml{"a:\n\tb: 1", "p:2:1: a tab in the indentation"},
                      BadYaml{"a:\n  \tb: 1", "p:2:3: a tab in the indentation"},
                      BadYaml{"b: 1\na: [1, 2", "p:2:4: this [ is never closed"},
                      BadYaml{"a: {b: 1", "p:1:4: this { is never closed"},
                      BadYaml{"a: \"abc", "p:1:8: this is no YAML: illegal EOF in scalar"},
                      BadYaml{"a: b: c", "p:1:5: this is no YAML"},
                      BadYaml{": 5", "p:1:1: a key is missing before the colon"},
                      BadYaml{"? [a]\n: 5", "p:1:3: a key must be a word"},
                      BadYaml{"a: 1 # c\n}", "p:2:1: this is no YAML"},
                      BadYaml{"a: \xff", "p:1:4: not UTF-8"}, BadYaml{"a: \xC0\x80", "p:1:4: not UTF-8"},
                      BadYaml{"a: \xED\xA0\x80", "p:1:4: not UTF-8"}, BadYaml{"a: b\x01", "p:1:5: a control"},
                      BadYaml{"%YAML 2.0\n---\na: 1", "p:1:1: this is no YAML: YAML major version"}));

TEST(YamlConfig, deepNestingIsRefusedWhereItExceedsTheLimit)
{
    std::string text;
    for (int i = 0; i < 100'000; ++i)
        text += "- ";
    EXPECT_EQ(complaintAbout(text), "p:1:65: nested deeper than 32 levels");
    EXPECT_NE(complaintAbout(std::string(100'000, '[')).find("p:1:"), std::string::npos);
}

TEST(YamlConfig, hugeTextsAreRefused)
{
    EXPECT_EQ(complaintAbout(std::string(kMaximalYamlSize + 1, ' ')),
              "p: larger than 4 MiB; a plan is a short text");
}

} // namespace
} // namespace mrpp
