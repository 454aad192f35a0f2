// Names in formats: legal, different, and unchanged where they can be.

#include "FormatNames.h"

#include "Index.h"
#include "Support.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace crossfield::test
{
namespace
{
NameRule Rule(bool isPlain, bool hasCase, std::size_t longest)
{
  NameRule rule;
  rule.isPlain = isPlain;
  rule.hasCase = hasCase;
  rule.longest = longest;
  return rule;
}

std::string Upper(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}
}

TEST(FormatNames, ChangesOnlyWhatAFormatCannotHave)
{
  const std::vector<std::string> names = { "wall", "inlet 1", "1", "", "a\"b", "été", "wall_2" };
  EXPECT_EQ(FormatNames(names, Rule(true, true, 80)),
    (std::vector<std::string>{
      "wall", "inlet_1", "side_1", "side_", "a_b", "side__t_", "wall_2" }));
  EXPECT_EQ(FormatNames(names, Rule(false, true, 80)),
    (std::vector<std::string>{ "wall", "inlet 1", "1", "side", "a'b", "été", "wall_2" }));
}

TEST(FormatNames, NumbersNamesThatBecomeEqual)
{
  EXPECT_EQ(FormatNames({ "a b", "a,b", "a_b", "a_b_2" }, Rule(true, true, 80)),
    (std::vector<std::string>{ "a_b_3", "a_b_4", "a_b", "a_b_2" }));
  EXPECT_EQ(FormatNames({ "Wall", "wall", "NALL" }, Rule(true, false, 80), { "nall" }),
    (std::vector<std::string>{ "Wall", "wall_2", "NALL_2" }));
}

TEST(FormatNames, CutsBetweenCharacters)
{
  EXPECT_EQ(
    FormatNames({ "éé", "ééé" }, Rule(false, true, 5)), (std::vector<std::string>{ "éé", "é_2" }));
}

TEST(FormatNames, AreLegalAndDifferentForRandomNames)
{
  Random random(20240917);
  const std::string characters = "aAbB1 _-,.;:\"'=*%#\t\n\xC3\xA9";
  for (const bool isPlain : { true, false })
  {
    const NameRule rule = Rule(isPlain, !isPlain, 8);
    std::set<std::string> given;
    while (given.size() < 1000)
    {
      std::string name;
      for (int i = random.Integer(0, 12); i > 0; --i)
      {
        name += characters[Index(random.Integer(0, static_cast<int>(characters.size()) - 1))];
      }
      given.insert(name);
    }
    const std::vector<std::string> names(given.begin(), given.end());
    const std::vector<std::string> made = FormatNames(names, rule);
    std::set<std::string> different;
    for (const std::string& name : made)
    {
      different.insert(isPlain ? Upper(name) : name);
      EXPECT_FALSE(name.empty());
      EXPECT_LE(name.size(), rule.longest);
      EXPECT_EQ(name.find_first_of("\"\n\t"), std::string::npos);
      EXPECT_TRUE(!isPlain ||
        (std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
          std::all_of(name.begin(), name.end(),
            [](unsigned char c)
            { return c < 0x80U && (std::isalnum(c) != 0 || c == '_' || c == '-'); })))
        << name;
    }
    EXPECT_EQ(different.size(), names.size());
    EXPECT_EQ(FormatNames(made, rule), made) << "legal names stay as they are";
  }
}
}
