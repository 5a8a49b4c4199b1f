#include "stl_file.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <sys/stat.h>

namespace carom {

// The parts of a binary file, in bytes.
static constexpr uint64_t TITLE = 80, HEAD = TITLE + 4, RECORD = 50, NORMAL = 12;
// Above this a file is refused before any of it is read.
static constexpr uint64_t MOST_TRIANGLES = 10000000, MOST_BYTES = 4000000000;
static constexpr int CORNERS = 9;

[[noreturn]] static void wrong(const std::string &path, const std::string &what)
{
  throw std::runtime_error("STL file '" + path + "'" + what);
}

static std::string contents_of(const std::string &path)
{
  // A pipe would wait to be opened.
  struct stat status;
  if (stat(path.c_str(), &status) == 0 && (status.st_mode & S_IFMT) != S_IFREG)
    wrong(path, " cannot be read: it must be a regular file");
  const std::unique_ptr<FILE, int (*)(FILE *)> file(fopen(path.c_str(), "rb"), fclose);
  if (!file) wrong(path, std::string(" cannot be opened: ") + strerror(errno));
  const bool at_end = fseek(file.get(), 0, SEEK_END) == 0;
  const long size = at_end ? ftell(file.get()) : -1;
  if (size < 0 || fseek(file.get(), 0, SEEK_SET) != 0) wrong(path, " cannot be read: it must be a regular file");
  if (static_cast<uint64_t>(size) > MOST_BYTES)
    wrong(path, " has " + std::to_string(size) + " bytes: must be at most " + std::to_string(MOST_BYTES));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (fread(&bytes[0], 1, bytes.size(), file.get()) != bytes.size()) wrong(path, " cannot be read to its end");
  return bytes;
}

static uint64_t stated_count(const std::string &bytes)
{
  uint64_t count = 0;
  for (int k = 3; k >= 0; k--) count = 256 * count + static_cast<unsigned char>(bytes[TITLE + k]);
  return count;
}

static std::vector<double> of_binary(const std::string &path, const std::string &bytes)
{
  const uint64_t count = stated_count(bytes);
  if (count > MOST_TRIANGLES)
    wrong(path, " has " + std::to_string(count) + " triangles: must be at most " + std::to_string(MOST_TRIANGLES));
  std::vector<double> triangles;
  triangles.reserve(count * CORNERS);
  for (uint64_t n = 0; n < count; n++) {
    float numbers[CORNERS];
    memcpy(numbers, bytes.data() + HEAD + n * RECORD + NORMAL, sizeof numbers);
    triangles.insert(triangles.end(), numbers, numbers + CORNERS);
  }
  return triangles;
}

// The words of a text, one after the other.
class Words {
 public:
  Words(const std::string &path, const std::string &text) : path(path), at(text.c_str()) {}

  // The next word; empty at the end of the text.
  std::string next()
  {
    at += strspn(at, SPACES);
    const std::size_t length = strcspn(at, SPACES);
    at += length;
    return std::string(at - length, length);
  }
  // Reads these words.
  void expect(const char *wanted, std::size_t triangle)
  {
    const std::string word = next();
    if (word != wanted) fail(triangle, "'" + word.substr(0, 40) + "' must be '" + wanted + "'");
  }
  double number(std::size_t triangle)
  {
    const std::string word = next();
    char *end;
    const double value = strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0') fail(triangle, "'" + word.substr(0, 40) + "' must be a number");
    return value;
  }
  // The name of a solid, with any words.
  void skip_line() { at += strcspn(at, "\n\r"); }
  [[noreturn]] void fail(std::size_t triangle, const std::string &what) const
  {
    wrong(path, ": triangle " + std::to_string(triangle) + " is not valid: " + what);
  }

 private:
  static constexpr const char *SPACES = " \t\n\r\f\v";
  const std::string &path;
  const char *at;
};

// The rest of a triangle, after its word 'facet'.
static void take_facet(Words &words, std::vector<double> &triangles)
{
  const std::size_t nth = triangles.size() / CORNERS + 1;
  if (nth > MOST_TRIANGLES) words.fail(nth, "there must be at most " + std::to_string(MOST_TRIANGLES));
  words.expect("normal", nth);
  for (int k = 0; k < 3; k++) words.number(nth);
  words.expect("outer", nth);
  words.expect("loop", nth);
  for (int corner = 0; corner < 3; corner++) {
    words.expect("vertex", nth);
    for (int k = 0; k < 3; k++) triangles.push_back(words.number(nth));
  }
  words.expect("endloop", nth);
  words.expect("endfacet", nth);
}

static std::vector<double> of_text(const std::string &path, const std::string &text)
{
  std::vector<double> triangles;
  Words words(path, text);
  words.next();
  words.skip_line();
  bool is_open = true;
  for (std::string word = words.next(); !word.empty(); word = words.next()) {
    if (word == "facet" && is_open) {
      take_facet(words, triangles);
    } else if (word == (is_open ? "endsolid" : "solid")) {
      is_open = !is_open;
      words.skip_line();
    } else {
      words.fail(triangles.size() / CORNERS + 1,
                 "'" + word.substr(0, 40) + (is_open ? "' must be 'facet' or 'endsolid'" : "' must be 'solid'"));
    }
  }
  if (!is_open) return triangles;
  wrong(path, " ends after triangle " + std::to_string(triangles.size() / CORNERS) + ": 'endsolid' is missing");
}

std::vector<double> read_stl(const std::string &path)
{
  const std::string bytes = contents_of(path);
  std::vector<double> triangles;
  if (bytes.size() >= HEAD && bytes.size() == HEAD + RECORD * stated_count(bytes))
    triangles = of_binary(path, bytes);
  else if (bytes.compare(0, 5, "solid") == 0 && bytes.find('\0') == std::string::npos)
    triangles = of_text(path, bytes);
  else if (bytes.size() < HEAD)
    wrong(path, " has " + std::to_string(bytes.size()) + " bytes: must begin with 'solid', or have at least 84");
  else
    wrong(path, " states " + std::to_string(stated_count(bytes)) + " triangles, but has " +
                    std::to_string(bytes.size()) + " bytes: must have " +
                    std::to_string(HEAD + RECORD * stated_count(bytes)) + ", or be a text that begins with 'solid'");
  if (triangles.empty()) wrong(path, " has no triangles: must have at least one");
  return triangles;
}

}    // namespace carom
