// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/text/escape.h"

#include <gtest/gtest.h>

#include "core/files/text/number.h"
#include "core/files/text/utf8.h"

namespace cvo::escape_test {
namespace {

TEST(Base64, MatchesTheVectorsOfRfc4648) {
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foo"), "Zm9v");
  EXPECT_EQ(Base64("foob"), "Zm9vYg==");
  EXPECT_EQ(Base64("\xff\xfe"), "//4=");
}

TEST(Escaped, TextStaysText) {
  EXPECT_EQ(HtmlEscaped("<b a='1' c=\"2\">&"), "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;");
  EXPECT_EQ(MarkdownEscaped("a|b_c [x](y) $"), "a\\|b\\_c [x]\\(y) \\$");
  EXPECT_EQ(MarkdownEscaped("https://a.b www.c.d 1:2"), "https\\://a.b www\\.c.d 1:2");
}

TEST(Utf8, PrintableReplacesControlCharacters) {
  EXPECT_EQ(PrintableLines("a\r\nb\x1b\tc\rd\n"), "a\r\nb\xEF\xBF\xBD c d\n");
  EXPECT_EQ(Printable("a\r\nb"), "a  b");
}

TEST(Utf8, AcceptsOnlyCompleteValidSequences) {
  EXPECT_TRUE(IsUtf8("plain, \xc3\xa9, \xef\xbf\xbd, \xf0\x9f\x98\x80"));
  for (const char* text : {"\xff", "a\xc3", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80"}) {
    EXPECT_FALSE(IsUtf8(text));
  }
  EXPECT_TRUE(HasControl("a\x1b[0m"));
  EXPECT_FALSE(HasControl("\xc3\xa9"));
}

TEST(Number, FixedAndGeneral) {
  EXPECT_EQ(FormatFixed(2.5, 2), "2.50");
  EXPECT_EQ(FormatGeneral(1234567.0, 4), "1.235e+06");
  EXPECT_EQ(FormatGeneral(0.0625, 4), "0.0625");
  EXPECT_EQ(FormatSigned(0.5, 3) + FormatSigned(-2.0, 3) + FormatSigned(0.0, 3), "+0.5-2+0");
  EXPECT_EQ(RoundedTo(0.0123456, 4), 0.01235);
}

}  // namespace
}  // namespace cvo::escape_test
