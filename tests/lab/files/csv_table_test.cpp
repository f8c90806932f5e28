#include "lab/files/csv_table.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "lab/files/csv.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {
namespace {

namespace fs = std::filesystem;

class CsvTables : public ::testing::Test {
  protected:
    fs::path file = fs::temp_directory_path() / ("flipside-table-" + std::to_string(getpid()) + ".csv");
    void TearDown() override { fs::remove(file); }

    CsvTable read(const std::string& text) {
        std::ofstream(file) << text;
        return CsvTable(file);
    }
    void expect_refused(const std::string& text, const std::string& words) {
        try {
            const CsvTable table = read(text);
            for (std::size_t row = 0; row < table.rows(); ++row) static_cast<void>(table.number(row, "x"));
            FAIL() << text;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(file.filename()), std::string::npos) << error.what();
        }
    }
};

TEST_F(CsvTables, ReadBackWhatRowsWrote) {
    {
        std::ofstream out(file);
        CsvRow row;
        row.add("name").add("x").add("n").write(out);
        row.add("a, \"b\"").add(1.0 / 3).add(std::uint64_t{7}).write(out);
        row.add("").add(-1e-300).add(std::uint32_t{0}).write(out);
        row.add("d").add(std::numeric_limits<double>::infinity()).add(std::uint32_t{1}).write(out);
    }
    const CsvTable table(file);
    ASSERT_EQ(table.rows(), 3U);
    EXPECT_EQ(table.columns(), (std::vector<std::string>{"name", "x", "n"}));
    EXPECT_EQ(table.text(0, "name"), "a, \"b\"");
    EXPECT_EQ(table.number(0, "x"), 1.0 / 3);
    EXPECT_EQ(table.count(0, "n"), 7U);
    EXPECT_EQ(table.text(1, "name"), "");
    EXPECT_EQ(table.number(1, "x"), -1e-300);
    EXPECT_EQ(table.number(2, "x"), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(table.has("n"));
    EXPECT_FALSE(table.has("m"));
}

// A spreadsheet would take them for formulas, so a ' stands before them in the file.
TEST_F(CsvTables, ReadBackTextThatBeginsLikeAFormula) {
    const std::vector<std::string> texts{"-1.0", "=1+1", "+a", "@b", "'c", "''", "=\"d\", e", "'"};
    {
        std::ofstream out(file);
        CsvRow row;
        row.add("name").write(out);
        for (const std::string& text : texts) row.add(text).write(out);
    }
    const CsvTable table(file);
    for (std::size_t row = 0; row < texts.size(); ++row) EXPECT_EQ(table.text(row, "name"), texts[row]);
    EXPECT_THROW(static_cast<void>(read("x\n'5").number(0, "x")), InputError) << "that is text";
}

TEST_F(CsvTables, MayComeFromElsewhere) {
    const CsvTable table = read("x,y\r\n1,\"2\"\r\n3,4");  // other line ends, none at all in the last
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_EQ(table.number(0, "y"), 2);
    EXPECT_EQ(table.number(1, "y"), 4);
}

TEST_F(CsvTables, TakeOnlyPlainNamesForNames) {
    const auto name_of = [&](const std::string& name) {
        std::string field = "\"";
        for (const char c : name) field.append(c == '"' ? 2 : 1, c);
        return read("n,name\n1,plain\n2," + field + "\"\n").name(1, "name");
    };
    for (const std::string good : {"a", "0", "pinball-8", "A.b_c-9"}) EXPECT_EQ(name_of(good), good);
    EXPECT_EQ(name_of(std::string(100, 'a')), std::string(100, 'a'));
    for (const std::string& bad :
         {std::string(""),     std::string("../x"),   std::string("a/b"),      std::string(".."),
          std::string("-a"),   std::string("=1+1"),   std::string("+1"),       std::string("@a"),
          std::string("a b"),  std::string("a\nb"),   std::string("\x1b[31m"), std::string("<script>"),
          std::string("\x7f"), std::string("\u009b"), std::string("\u202e"),   std::string("\xff"),
          std::string("a\"b"), std::string("\0", 1),  std::string(101, 'a'),   std::string(100'000, 'a')}) {
        try {
            FAIL() << name_of(bad);
        } catch (const InputError& error) {
            const std::string said = error.what();
            EXPECT_NE(said.find("line 3: name '"), std::string::npos) << said;
            EXPECT_NE(said.find("letters, digits"), std::string::npos) << said;
            EXPECT_LT(said.size(), 400U);
        }
    }
}

TEST_F(CsvTables, TakeOnlyKnownWordsWhereTheyAreKnown) {
    constexpr std::string_view known[] = {"", "lost"};
    const CsvTable table = read("x,y\nlost,1\n,2\nfound,3\n");
    EXPECT_EQ(table.one_of(0, "x", known), "lost");
    EXPECT_EQ(table.one_of(1, "x", known), "");
    EXPECT_THROW(static_cast<void>(table.one_of(2, "x", known)), InputError);
    EXPECT_THROW(static_cast<void>(table.text(3, "x")), InputError);
}

TEST_F(CsvTables, SayWhereTheyAreBad) {
    expect_refused("x,y\n1,2\n3\n", "line 3: has 1 fields; its header names 2");
    expect_refused("x\n\"1\n", "line 2: a quoted field has no end");
    expect_refused("x\n\"1\"2\n", "line 2: a field goes on after its closing quote");
    expect_refused("y\n1\n", "has no column 'x'");
    expect_refused("x,y\n\"1\",2\n1s,2\n", "line 3: x '1s' is not a number");
    EXPECT_THROW(CsvTable(fs::path("/nowhere.csv")), InputError);
    const CsvTable table = read("x\n-1\n");
    EXPECT_THROW(static_cast<void>(table.count(0, "x")), InputError);
}

}  // namespace
}  // namespace flipside::lab
