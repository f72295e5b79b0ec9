// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <locale>
#include <string>

#include "command/temporary_directory.h"

namespace litfog::test {

/// Makes a locale with a decimal comma and points between thousands the program's, in C and C++, for as long as it
/// lives. It is compiled by localedef (libc-bin) from a source and a character map of its own: no locale has to be
/// installed. Child processes that are given LC_ALL=comma have it, too.
class CommaLocale {
 public:
  CommaLocale() {
    const std::filesystem::path folder = directory_.path();
    std::ofstream(folder / "source") << "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\n"
                                        "END LC_NUMERIC\n";
    std::ofstream charmap(folder / "charmap");
    charmap << "<code_set_name> ASCII\n<comment_char> %\n<escape_char> /\nCHARMAP\n";
    char line[32];
    for (int byte = 0; byte < 128; ++byte) {
      std::snprintf(line, sizeof line, "<U%04X> /x%02x c\n", unsigned(byte), unsigned(byte));
      charmap << line;
    }
    charmap << "END CHARMAP\n";
    charmap.close();
    const std::string at = "cd '" + folder.string() + "' && ";
    std::system((at + "localedef --no-archive -c -f ./charmap -i ./source ./comma >log 2>&1").c_str());
    setenv("LOCPATH", folder.c_str(), 1);
    std::setlocale(LC_ALL, "comma");
    // Not std::locale("comma"): glibc's newlocale leaks the folders that it searched when LOCPATH is set.
    std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
    std::snprintf(line, sizeof line, "%g", 1.5);
    EXPECT_STREQ(line, "1,5");
  }
  ~CommaLocale() {
    std::locale::global(std::locale::classic());
    unsetenv("LOCPATH");
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

 private:
  struct CommaNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };

  TemporaryDirectory directory_;
};

}  // namespace litfog::test
