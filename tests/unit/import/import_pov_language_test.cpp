// The POV-Ray interpreter with statements of its own, without scenes: what it asks for, and what names give.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "import/pov/language/interpreter.h"

namespace strad {
namespace {

struct Coin {
  std::string name;
  double value = 0;
};

// A language of coins: `coin { VALUE }`.
class Coins : public PovStatements {
 public:
  explicit Coins(const std::string& path) : in(options, run, &files, &report, this) {
    run.most_steps = 200'000;  // for speed
    run.most_words = 2'000'000;
    run.most_bytes = 50'000'000;
    in.open(path);
  }

  std::any describe(std::string_view word) override {
    if (word != "coin") return {};
    in.take();
    in.expect("{");
    const Coin coin{"", in.number()};
    in.expect("}");
    return coin;
  }
  void name_declared(const std::string& name, std::any* value) override {
    std::any_cast<Coin&>(*value).name = name;
  }
  PovNumbers measured(const std::string&) override { return {}; }
  std::optional<Vec3> transformed(const std::any&, Vec3) override { return {}; }
  void default_block() override {
    in.skip_block();
    ++default_blocks;
  }

  SkipOptions options;
  PovRun run;
  PovFiles files;
  ImportReport report;
  PovInterpreter in;
  int default_blocks = 0;
};

class ImportPovLanguage : public testing::Test {
 protected:
  ImportPovLanguage()
      : path_(testing::TempDir() + "/" + testing::UnitTest::GetInstance()->current_test_info()->name()) {}
  ~ImportPovLanguage() override { std::filesystem::remove(path_); }

  std::unique_ptr<Coins> opened(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    return std::make_unique<Coins>(path_);
  }

  const std::string path_;
};

TEST_F(ImportPovLanguage, ADeclaredThingComesBackWithItsName) {
  const auto coins = opened("#declare Penny = coin { 1/100 }; #declare Copper = Penny; Copper Penny");
  std::string word;
  const auto copper = coins->in.named<Coin>(&word);
  ASSERT_TRUE(copper);
  EXPECT_EQ(word, "Copper");
  EXPECT_EQ(copper->name, "Copper");
  EXPECT_EQ(copper->value, 0.01);
  EXPECT_EQ(coins->in.named<Coin>()->name, "Penny");
  EXPECT_EQ(coins->in.peek().kind, PovKind::kEnd);
}

TEST_F(ImportPovLanguage, NothingIsTakenWhereTheNameStandsForSomethingElse) {
  const auto coins = opened("#declare A = 5; #declare B = \"five\"; A B C");
  EXPECT_FALSE(coins->in.named<Coin>());
  EXPECT_EQ(coins->in.number(), 5);
  EXPECT_FALSE(coins->in.named<Coin>());
  EXPECT_EQ(coins->in.named<std::string>(), "five");
  EXPECT_FALSE(coins->in.named<Coin>());
  EXPECT_TRUE(coins->in.next_is("C"));
}

TEST_F(ImportPovLanguage, ArraysAndMacrosCarryThings) {
  const auto coins = opened(R"(
    #declare Purse = array[2] { coin { 2 }, coin { 3 } };
    #macro Twice(C, N) C N #end
    Purse[1] Twice(Purse[0], 7))");
  EXPECT_EQ(coins->in.named<Coin>()->value, 3);
  EXPECT_EQ(coins->in.named<Coin>()->value, 2);
  EXPECT_EQ(coins->in.number(), 7);
}

TEST_F(ImportPovLanguage, AnArrayOfManyKindsIsReadAsWhatItsFirstElementIs) {
  const auto coins = opened("#declare Purse = array[2] { coin { 2 }, 3 }; Purse[0] Purse[1]");
  EXPECT_EQ(coins->in.named<Coin>()->value, 2);
  try {
    coins->in.named<Coin>();
    FAIL() << "a number was taken for a coin";
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find("expected an element of the array Purse"), std::string::npos)
        << error.what();
  }
}

// POV-Ray 3.7 prints 3, 10, 2 and 2 for the same.
TEST_F(ImportPovLanguage, DeclareChangesTheNameThatIsInScope) {
  const auto coins = opened(R"(
    #declare I = 10;
    #macro Count(N) #local I = 0; #while (I < N) #declare I = I + 1; #end I #end
    Count(3) I
    #macro Inner() #declare Q = 2; #end
    #macro Outer() #local Q = 1; Inner() Q #end
    Outer()
    #local A = 1; #declare A = 2; A
    #ifdef (Q) 99 #end)");
  EXPECT_EQ(coins->in.number(), 3);
  EXPECT_EQ(coins->in.number(), 10);
  EXPECT_EQ(coins->in.number(), 2);
  EXPECT_EQ(coins->in.number(), 2);
  EXPECT_EQ(coins->in.peek().kind, PovKind::kEnd);
}

// Each is a few lines that would fill any memory, or go on for hours.
TEST_F(ImportPovLanguage, WhatGrowsWithoutEndIsRefused) {
  const struct {
    std::string text, says;
  } cases[] = {
      {"#declare S = \"xx\"; #for (I, 1, 60) #declare S = concat(S, S); #end", "more than 65536 characters"},
      {"#macro A(S, N) #if (N > 0) A(concat(S, S), N - 1) #end #end A(\"xx\", 60)",
       "more than 65536 characters"},
      {"#macro A() A() A() #end A()", "nested too deep"},
      {"#declare S = \"x\"; #for (I, 1, 16) #declare S = concat(S, S); #end #declare P = array[1000][100];"
       "#for (I, 0, 999) #for (J, 0, 99) #declare P[I][J] = S; #end #end",
       "more than 50 MB"},
      {"#for (I, 1, 1e6) #local P = array[1e8]; #end", "more than 50 MB"},
      {"#declare P = array[1e6];", "more than 50 MB"},
      {"#while (1) #end", "turns of loops"},
      {"#declare F = function(x) { x } #for (I, 1, 1e6) #declare F = function(x) { F(x) } #end",
       "within each other too deep"},
      {"#declare A = array[1]; #for (I, 1, 1e6) #declare B = array[1]; #declare B[0] = A; #declare A = B; "
       "#end",
       "within each other too deep"},
      {"#macro W() #if (0) " + std::string(200, '+') + " #end #end #for (I, 1, 1e5) W() #end", "words"},
      {"#declare R = seed(1e30);", "too large"},
      {"#declare R = seed(1); #declare X = rand(1e30);", "too large"}};
  for (const auto& one : cases) {
    try {
      opened(one.text)->in.peek();
      FAIL() << "accepted: " << one.text;
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(one.says), std::string::npos)
          << one.text << ": " << error.what();
    }
  }
}

TEST_F(ImportPovLanguage, DefaultIsHandedOnEachTimeItIsObeyed) {
  const auto coins = opened("#for (I, 1, 3) #default { coin { I } } #end");
  EXPECT_EQ(coins->in.peek().kind, PovKind::kEnd);
  EXPECT_EQ(coins->default_blocks, 3);
}

TEST_F(ImportPovLanguage, WhatNobodyKnowsIsSkippedWhereDeclaredAndKnownToBe) {
  const auto coins = opened("#declare N = normal { bumps { 1 } }; #ifdef (N) 1 #else 2 #end");
  EXPECT_EQ(coins->in.number(), 1);
}

// A macro gives the value and goes on to its #end after that: the name is its caller's nevertheless.
TEST_F(ImportPovLanguage, names_that_macros_give_values_are_where_they_are_declared) {
  const auto coins = opened(
      "#macro V(A) A * 2 #end\n#macro W(A) #if (A > 1) A; #else 0; #end #end\n"
      "#macro U() #local L = V(3)\n#local M = W(4)\n#if (M) L + M #end #end\nU()");
  EXPECT_EQ(coins->in.number(), 10);
}

}  // namespace
}  // namespace strad
