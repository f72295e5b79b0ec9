// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/gldf.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include "command/temporary_directory.h"
#include "core/value_errors.h"
#include "photometry/memory_limit.h"
#include "photometry/photometric_file.h"
#include "photometry/zip_file.h"

namespace litfog::test {
namespace {

const std::string kSpot = bytes_of(LITFOG_PHOTOMETRY_DIR "/isym_4.ldt");
const std::string kFlood = bytes_of(LITFOG_PHOTOMETRY_DIR "/edition_2019.ies");

std::string product(const std::string& files) {
  return "<?xml version=\"1.0\"?>\n<Root><Header><Manufacturer>litfog</Manufacturer></Header>\n"
         "<GeneralDefinitions><Files>\n" +
         files + "</Files></GeneralDefinitions></Root>\n";
}

std::string file_element(const std::string& content_type, const std::string& type, const std::string& name) {
  return "<File id=\"" + name + "\" contentType=\"" + content_type + "\" type=\"" + type + "\">" + name + "</File>\n";
}

class Gldf : public ::testing::Test {
 protected:
  std::string path(const std::string& name = "lamp.gldf") const { return (directory_.path() / name).string(); }

  void write(const ZipEntries& entries) const { write_zip(path(), entries); }

  std::string error_of(const std::string& name = "lamp.gldf") const {
    return photometry_error_of([&] { read_luminaire(path(name)); });
  }

 private:
  TemporaryDirectory directory_;
};

TEST_F(Gldf, OnlyPhotometricFileIsTheLamp) {
  write({{"product.xml", product(file_element("image/jpg", "localFileName", "a.jpg") +
                                 file_element("ldc/eulumdat", "url", "https://litfog.example/a.ldt") +
                                 file_element("ldc/eulumdat", "localFileName", "spot.ldt"))},
         {"image/a.jpg", "JFIF"},
         {"ldc/spot.ldt", kSpot}});
  const Luminaire luminaire = read_luminaire(path());
  EXPECT_EQ(luminaire.file, path("lamp.gldf/ldc/spot.ldt"));
  expect_same_beam(luminaire, our_luminaire("isym_4.ldt"));
}

TEST_F(Gldf, FilesAreListedAndReadByTheirPaths) {
  write({{"product.xml", product(file_element("ldc/eulumdat", "localFileName", "spot.ldt") +
                                 file_element("ldc/ies", "localFileName", "flood.ies"))},
         {"ldc/spot.ldt", kSpot},
         {"ldc/flood.ies", kFlood}});
  const std::vector<std::string> files{path("lamp.gldf/ldc/spot.ldt"), path("lamp.gldf/ldc/flood.ies")};
  EXPECT_EQ(list_gldf(path()), files);
  expect_same_beam(read_luminaire(files[0]), our_luminaire("isym_4.ldt"));
  expect_same_beam(read_luminaire(files[1]), our_luminaire("edition_2019.ies"));
  EXPECT_EQ(error_of(), " photometric file: must be named where there are several: " + files[0] + " " + files[1]);
}

TEST_F(Gldf, FileThatIsDefinedTwiceIsListedOnce) {
  const std::string spot = file_element("ldc/eulumdat", "localFileName", "spot.ldt");
  write({{"product.xml", product(spot + spot)}, {"ldc/spot.ldt", kSpot}});
  EXPECT_EQ(list_gldf(path()), std::vector<std::string>{path("lamp.gldf/ldc/spot.ldt")});
  EXPECT_EQ(read_luminaire(path()).file, path("lamp.gldf/ldc/spot.ldt"));
}

TEST_F(Gldf, NamesAreFoundInUtf8AndInTheCodePageOfWesternZipPrograms) {
  const std::string files = product(file_element("ldc/eulumdat", "localFileName", "Röhre.ldt"));
  for (const char* stored : {"ldc/R\xC3\xB6hre.ldt", "ldc/R\x94hre.ldt"}) {
    write({{"product.xml", files}, {stored, kSpot}});
    expect_same_beam(read_luminaire(path()), our_luminaire("isym_4.ldt"));
  }
  write({{"product.xml", files}, {"ldc/R\xF6hre.ldt", kSpot}});
  EXPECT_EQ(error_of(), " file: must be in the archive");
}

TEST_F(Gldf, NamesAreFoundAsWindowsWritesThem) {
  const std::string slashed = product(file_element("ldc/eulumdat", "localFileName", "deep/spot.ldt"));
  const std::string backslashed = product(file_element("ldc/eulumdat", "localFileName", "deep\\spot.ldt"));
  for (const std::string& files : {slashed, backslashed}) {
    for (const char* stored : {"ldc/deep/spot.ldt", "ldc\\deep\\spot.ldt", "ldc/deep\\spot.ldt"}) {
      write({{"product.xml", files}, {stored, kSpot}});
      EXPECT_EQ(list_gldf(path()), std::vector<std::string>{path("lamp.gldf/ldc/deep/spot.ldt")}) << stored;
      expect_same_beam(read_luminaire(path()), our_luminaire("isym_4.ldt"));
      expect_same_beam(read_luminaire(path("lamp.gldf/ldc/deep/spot.ldt")), our_luminaire("isym_4.ldt"));
    }
  }
}

/// The name of the i-th of many photometric files, of even length.
std::string numbered(int i) { return std::to_string(100'000 + i) + ".ldt"; }

/// A container of such files.
ZipEntries numbered_files(int count, const std::string& bytes) {
  ZipEntries entries;
  std::string files;
  for (int i = 0; i < count; ++i) {
    files += file_element("ldc/eulumdat", "localFileName", numbered(i));
    entries.emplace_back("ldc/" + numbered(i), bytes);
  }
  entries.emplace_back("product.xml", product(files));
  return entries;
}

/// Where the record of an entry begins in an archive's directory.
std::size_t directory_record(const std::string& archive, const std::string& entry) {
  constexpr std::size_t kNameOffset = 46;
  return archive.rfind(entry) - kNameOffset;
}

TEST_F(Gldf, EntriesThatShareTheirBytesAreAnError) {
  write(numbered_files(3, kSpot));
  std::string bytes = bytes_of(path());
  constexpr std::size_t kOffset = 42;  // the entry's position, in a record
  const auto place = [&](int i) { return directory_record(bytes, "ldc/" + numbered(i)) + kOffset; };
  bytes.replace(place(2), 4, bytes, place(0), 4);
  std::ofstream(path(), std::ios::binary) << bytes;
  EXPECT_EQ(sentence_of<InputError>([&] { list_gldf(path()); }),
            path("lamp.gldf/ldc/" + numbered(2)) + ": file: must not share its bytes with ldc/" + numbered(0));
}

TEST_F(Gldf, PhotometricFilesOfMoreThan256MebibytesTogetherAreAnError) {
  write(numbered_files(5, kSpot));
  std::string bytes = bytes_of(path());
  constexpr std::size_t kSize = 24;  // the count of unpacked bytes, in a record
  for (int i = 0; i < 5; ++i) {
    bytes.replace(directory_record(bytes, "ldc/" + numbered(i)) + kSize, 4, std::string("\0\0\0\4", 4));  // 64 MiB
    std::ofstream(path(), std::ios::binary) << bytes;
    if (i == 2) {
      EXPECT_EQ(list_gldf(path()).size(), 5u);
    }
  }
  EXPECT_EQ(error_of(), " photometric files: must not unpack to more than 268435456 bytes");
}

TEST_F(Gldf, ArchiveOfMoreThan10000EntriesIsAnError) {
  write(numbered_files(9'999, ""));
  EXPECT_EQ(list_gldf(path()).size(), 9'999u);
  EXPECT_EQ(error_of().substr(error_of().rfind(' ')), " more");
  write(numbered_files(10'000, ""));
  EXPECT_EQ(error_of(), " zip archive: must not have more than 10000 entries");
}

TEST_F(Gldf, FilesOfAContainerAreFoundWithoutReadingItsDirectoryAgain) {
  write(numbered_files(2, kSpot));
  const GldfContainer container(path());
  std::string bytes = bytes_of(path());
  bytes.replace(directory_record(bytes, "ldc/" + numbered(0)), 4, "gone");
  std::ofstream(path(), std::ios::binary) << bytes;
  EXPECT_THROW(list_gldf(path()), InputError);
  expect_same_beam(container.read(container.files()[1]), our_luminaire("isym_4.ldt"));
  EXPECT_THROW(container.read(container.files()[0]), InputError);
}

TEST_F(Gldf, ErrorsNameTheFileInTheContainer) {
  const std::string ldt = product(file_element("ldc/eulumdat", "localFileName", "spot.ldt"));
  const auto error = [&](const ZipEntries& entries) {
    write(entries);
    try {
      read_luminaire(path());
    } catch (const InputError& thrown) {
      return std::string(thrown.what()).substr(path().size());
    }
    return std::string("(accepted)");
  };
  EXPECT_EQ(error({{"ldc/spot.ldt", kSpot}}), "/product.xml: file: must be in the archive");
  EXPECT_EQ(error({{"product.xml", "<Root>"}}), "/product.xml:1:6: XML: must be well-formed: Start-end tags mismatch");
  EXPECT_EQ(error({{"product.xml", product("")}}),
            "/product.xml:2:1: element = Root: must define a File of a contentType ldc/... that is in the archive");
  EXPECT_EQ(error({{"product.xml", ldt}}), "/ldc/spot.ldt: file: must be in the archive");
  EXPECT_EQ(error({{"product.xml", ldt}, {"ldc/spot.ldt", "a\nb\n"}}),
            "/ldc/spot.ldt:2:1: type indicator Ityp = b: must be a finite number");
}

TEST_F(Gldf, FileThatIsPackedInAnotherWayIsAnError) {
  write({{"product.xml", "<Root/>"}});
  std::string bytes = bytes_of(path());
  constexpr char kBzip2 = 12;
  bytes[8] = bytes[bytes.find("PK\1\2") + 10] = kBzip2;
  std::ofstream(path(), std::ios::binary) << bytes;
  EXPECT_EQ(error_of(), " file: must be readable: its data are broken, or packed in another way");
}

#ifndef LITFOG_SANITIZED  // sanitizers' own memory would count
TEST_F(Gldf, ZipBombIsAnErrorBeforeItIsUnpacked) {
  write({{"product.xml", std::string(std::size_t{96} << 20, ' ')}});  // 96 kilobytes when packed
  const MemoryLimit limit(std::size_t{256} << 20);
  EXPECT_EQ(error_of(), " file: must not be larger than 67108864 bytes");
}

TEST_F(Gldf, XmlOfTheLargestSizeIsReadWithinTheStatedMemory) {
  std::string xml = "<Root>";
  while (xml.size() < (std::size_t{16} << 20) - 16) xml += "<a b=\"\"/>";
  write({{"product.xml", xml + "</Root>"}});
  const MemoryLimit limit(kMaxLuminaireMemory);
  EXPECT_NE(error_of().find("must define a File"), std::string::npos) << error_of();
}
#endif

}  // namespace
}  // namespace litfog::test
