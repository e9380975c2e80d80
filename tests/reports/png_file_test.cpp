#include "reports/png_file.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <sstream>
#include <string_view>

#include "geometry/error.hpp"
#include "tests/reports/empty_folder.hpp"
#include "tests/reports/read_png.hpp"

using namespace rayaudit;
using Pixel = PngFile::Pixel;

namespace {

/// A pixel that is told from others by its place, and does not compress.
Pixel pixel(int column, int row) {
  std::uint32_t mixed =
      static_cast<std::uint32_t>(column) * 1021U + static_cast<std::uint32_t>(row);
  for (const std::uint32_t factor : {0x7feb352dU, 0x846ca68bU})
    mixed = (mixed ^ (mixed >> 16U)) * factor;
  const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(mixed >> shift); };
  return {byte(24), byte(16), byte(8)};
}

std::vector<Pixel> rows(int width, int first, int last) {
  std::vector<Pixel> all;
  all.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(last - first));
  for (int row = first; row < last; ++row)
    for (int column = 0; column < width; ++column) all.push_back(pixel(column, row));
  return all;
}

bool same(const Pixel& a, const Pixel& b) {
  return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

/// Are the first rows of a picture those above, and the others black?
bool holds(const ReadPng& read, int written) {
  for (int row = 0; row < read.height; ++row)
    for (int column = 0; column < read.width; ++column)
      if (!same(read.at(column, row), row < written ? pixel(column, row) : Pixel{0, 0, 0}))
        return false;
  return true;
}

std::string content(const std::filesystem::path& path) {
  std::ostringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
  return all.str();
}

void put(const std::filesystem::path& path, std::string_view text) { std::ofstream(path) << text; }

const EmptyFolder folder("png_file_test");
const std::filesystem::path path = folder.path / "a.png";

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_written_in_bands_is_read_back_to_the_pixel) {
  PngFile file(path, 37, 29);
  file.write(rows(37, 0, 8));
  file.write(rows(37, 8, 9));
  file.write(rows(37, 9, 29));
  file.close();
  const ReadPng read = read_png(path);
  BOOST_TEST(read.width == 37);
  BOOST_TEST(read.height == 29);
  BOOST_TEST(holds(read, 29));
}

BOOST_AUTO_TEST_CASE(closed_early_the_rest_is_black) {
  PngFile file(path, 20, 50);
  file.write(rows(20, 0, 13));
  file.close();
  BOOST_TEST(holds(read_png(path), 13));
}

BOOST_AUTO_TEST_CASE(destroyed_early_it_is_the_same_file_as_closed_early) {
  {
    PngFile file(path, 20, 50);
    file.write(rows(20, 0, 13));
  }
  const std::string destroyed = content(path);
  BOOST_TEST(holds(read_png(path), 13));
  PngFile file(path, 20, 50);
  file.write(rows(20, 0, 13));
  file.close();
  BOOST_TEST((content(path) == destroyed));
}

BOOST_AUTO_TEST_CASE(closed_without_a_row_it_is_black) {
  PngFile(path, 3, 2).close();
  BOOST_TEST(holds(read_png(path), 0));
  BOOST_TEST(read_png(path).height == 2);
}

BOOST_AUTO_TEST_CASE(closing_twice_is_closing_once) {
  PngFile file(path, 4, 4);
  file.write(rows(4, 0, 4));
  file.close();
  const std::string closed = content(path);
  file.close();
  BOOST_TEST((content(path) == closed));
}

BOOST_AUTO_TEST_CASE(moved_it_writes_on) {
  PngFile first(path, 5, 6);
  first.write(rows(5, 0, 2));
  PngFile file = std::move(first);
  file.write(rows(5, 2, 6));
  file.close();
  BOOST_TEST(holds(read_png(path), 6));
}

BOOST_AUTO_TEST_CASE(rows_are_in_the_file_before_the_next_ones_come) {
  PngFile file(path, 300, 200);
  file.write(rows(300, 0, 1));
  BOOST_TEST(std::filesystem::file_size(path) > 0u);
  file.write(rows(300, 1, 50));
  const auto size = std::filesystem::file_size(path);
  BOOST_TEST(size > 20'000u);
  file.write(rows(300, 50, 100));
  BOOST_TEST(std::filesystem::file_size(path) > size + 20'000);
}

BOOST_AUTO_TEST_CASE(a_file_is_replaced_when_its_picture_begins_and_not_before) {
  const std::string old(100'000, 'x');
  put(path, old);
  { const PngFile never_begun(path, 4, 4); }
  BOOST_TEST((content(path) == old));
  PngFile file(path, 4, 4);
  BOOST_TEST((content(path) == old));
  file.write(rows(4, 0, 4));
  file.close();
  BOOST_TEST(holds(read_png(path), 4));
  BOOST_TEST(content(path).size() < 1000u);
}

BOOST_AUTO_TEST_CASE(a_new_file_that_is_never_begun_is_not_left_behind) {
  const std::filesystem::path fresh = folder.path / "fresh.png";
  { const PngFile never_begun(fresh, 4, 4); }
  BOOST_TEST(!std::filesystem::exists(fresh));
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_missing_is_told_in_a_sentence) {
  const std::filesystem::path nowhere = folder.path / "missing" / "a.png";
  BOOST_CHECK_EXCEPTION(PngFile(nowhere, 4, 4), Error, [&](const Error& error) {
    return error.what() ==
           "picture `" + nowhere.string() + "` cannot be written: No such file or directory";
  });
}

BOOST_AUTO_TEST_CASE(a_folder_in_its_place_is_told_too) {
  BOOST_CHECK_EXCEPTION(PngFile(folder.path, 4, 4), Error, [](const Error& error) {
    return std::string_view(error.what()).ends_with("cannot be written: Is a directory");
  });
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_told_by_the_call_that_meets_it_and_by_no_destructor) {
  PngFile file("/dev/full", 500, 1000);
  const auto is_full = [](const Error& error) {
    return std::string_view(error.what()) ==
           "picture `/dev/full` cannot be written: No space left on device";
  };
  BOOST_CHECK_EXCEPTION(file.write(rows(500, 0, 500)), Error, is_full);
}

BOOST_AUTO_TEST_CASE(a_full_disk_that_is_met_first_at_the_end_is_told) {
  PngFile file("/dev/full", 2, 2);
  BOOST_CHECK_EXCEPTION(file.close(), Error, [](const Error& error) {
    return std::string_view(error.what()).ends_with("No space left on device");
  });
}

BOOST_AUTO_TEST_CASE(a_very_wide_picture_is_one_too) {
  PngFile file(path, 3'000'000, 1);
  file.write(rows(3'000'000, 0, 1));
  file.close();
  std::ifstream read(path, std::ios::binary);
  std::string head(24, ' ');
  read.read(head.data(), 24);
  BOOST_TEST((head.substr(16, 4) == std::string("\x00\x2d\xc6\xc0", 4)));
}
