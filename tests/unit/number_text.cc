// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Numbers as text and back. Texts by hand:
//   0.1 is 0.1000000000000000055..., with 17 digits 0.10000000000000001, and
//   0.1 reads back to it; the least positive double is 2^-1074 = 4.94...e-324;
//   1e22 is a double; with 2 digits 1249 is 1200, 0.0996 is 0.1, and 2.5 is 2
//   without decimals (half to even, and 2.5 is a double).
// All digits are those of printf, an implementation of its own, for 1e5
// patterns of 64 bits drawn at random, among them not numbers; and 17 digits
// give the number back.
// Rows of a table: quotes around ',' and '"', which is doubled, and blanks for
// ends of lines. Nothing is allocated for the rows of a table that has had as
// many before: malloc is counted.

#include <thermocontact/base/text.h>
#include <thermocontact/output/csv_file.h>
#include <thermocontact/output/csv_rows.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>

#include "../tests.h"

namespace
{
  unsigned long n_allocations = 0;
}



extern "C"
{
  void *__libc_malloc(std::size_t);

  void *
  malloc(const std::size_t size)
  {
    ++n_allocations;
    return __libc_malloc(size);
  }
}



using namespace ThermoContact;

namespace
{
  /** numdiff takes 0.1 for 0.10000000000000001: texts are compared here. */
  void
  compare(const std::vector<std::pair<std::string, std::string>> &texts)
  {
    for (const auto &[written, by_hand] : texts)
      if (written != by_hand)
        deallog << '\'' << written << "', by hand '" << by_hand << '\''
                << std::endl;
    deallog << texts.size() << " texts compared" << std::endl;
  }



  void
  test_known_numbers()
  {
    const double inf = std::numeric_limits<double>::infinity();
    const auto all = [](const double x) { return significant(x, all_digits); };
    compare(
      {{all(0.1), "0.1"},
       {all(-0.5), "-0.5"},
       {all(-0.), "-0"},
       {all(1e22), "1e+22"},
       {all(std::numeric_limits<double>::denorm_min()), "5e-324"},
       {all(inf), "inf"},
       {all(-inf), "-inf"},
       {all(std::nan("")), "nan"},
       {text(1. / 3., ' ', 123456789., ' ', 7u, "x"),
        "0.333333 1.23457e+08 7x"},
       {fixed_point(2.5, 0), "2"},
       {fixed_point(99.96, 1), "100.0"},
       {about(1249.), "1200"},
       {about(0.0996), "0.1"},
       {about(-1.26e-7), "-1.3e-07"},
       {about(inf), "inf"},
       {gigabytes(2.34e9), "2.3 GB"},
       {clock_time(59.4), "0:59"},
       {clock_time(3599.4), "59:59"},
       {clock_time(3599.5), "1:00:00"},
       {clock_time(7384.), "2:03:04"},
       {clock_time(3.6e6 - 1.), "999:59:59"},
       {clock_time(3.6e6), "1000 h or more"},
       {join_words({"a", "", "b c"}), "a, b c"},
       {text(int(begins_with("+1", "+")), int(begins_with("1+", "+"))), "10"},
       {align_left("ab", 4), "ab  "},
       {align_left("abc", 2), "abc"},
       {align_right("ab", 4), "  ab"},
       {align_right("7", 2, '0'), "07"}});
  }



  void
  test_reading()
  {
    const auto read = [](const std::string &words) {
      const auto number = parse_number(words);
      return number ? significant(*number, all_digits) : "none";
    };
    compare({{read("1"), "1"},
             {read("+1"), "1"},
             {read("-1e-3"), "-0.001"},
             {read(".5"), "0.5"},
             {read("5."), "5"},
             {read("1E+2"), "100"},
             {read("4.9406564584124654e-324"), "5e-324"}});
    for (const char *words : {"",
                              "+",
                              "+-1",
                              "1e",
                              "1 ",
                              " 1",
                              "1,5",
                              "0x1",
                              "1d0",
                              "inf",
                              "nan",
                              "1e400",
                              "1e-400",
                              "2 3",
                              "--1",
                              "half",
                              "1..",
                              "e5",
                              "1_000"})
      if (parse_number(words))
        deallog << '\'' << words << "' is no number" << std::endl;
  }



  void
  test_random_numbers()
  {
    std::mt19937_64 generator(1);
    unsigned int    n_different = 0, n_changed = 0, n_too_long = 0;
    for (unsigned int i = 0; i < 100000; ++i)
      {
        const std::uint64_t bits = generator();
        double              value;
        std::memcpy(&value, &bits, sizeof(value));
        for (const int digits : {1, 2, 6, 12, 17})
          {
            char printed[40];
            std::snprintf(printed, sizeof(printed), "%.*g", digits, value);
            n_different += significant(value, digits) != printed;
          }
        if (std::isfinite(value))
          {
            const std::string words = significant(value, all_digits);
            n_changed += parse_number(words) != value;
            const std::string mantissa = words.substr(0, words.find('e'));
            const auto        n_digits =
              std::count_if(mantissa.begin(), mantissa.end(), [](const char c) {
                return std::isdigit(static_cast<unsigned char>(c)) != 0;
              });
            if (n_digits > 1 && words.find('e') != std::string::npos)
              n_too_long +=
                parse_number(significant(value, n_digits - 1)) == value;
          }
        const double seconds = generator() / 1e15;
        char         printed[40];
        std::snprintf(printed, sizeof(printed), "%.3f", seconds);
        n_different += fixed_point(seconds, 3) != printed;
      }
    deallog << "random: unlike printf " << n_different << ", not given back "
            << n_changed << ", with a digit too many " << n_too_long
            << std::endl;
  }



  struct Record
  {
    unsigned int number;
    double       value;
    bool         is_done;
    std::string  words;
  };

  void
  test_columns()
  {
    const CsvColumns<Record> columns = {{"number", &Record::number},
                                        {"value", &Record::value},
                                        {"a,b", &Record::value, 3},
                                        {"done", &Record::is_done},
                                        {"words", &Record::words},
                                        {"twice", [](const Record &record) {
                                           return 2 * record.number;
                                         }}};
    std::string              table   = csv_head(columns);
    append_csv_row(columns, {1, 0.1, true, "say \"a, b\""}, table);
    append_csv_row(columns, {2, 1. / 3., false, "two\nlines"}, table);
    compare({{table,
              "number,value,\"a,b\",done,words,twice\n"
              "1,0.1,0.1,1,\"say \"\"a, b\"\"\",2\n"
              "2,0.3333333333333333,0.333,0,two lines,4\n"},
             {join_words(split_row("1,\"say \"\"a, b\"\"\",,\"\",x\"2\"\"\"")),
              "1, say \"a, b\", x2\""},
             {text(split_row("1,,\"\"").size()), "3"}});
  }



  void
  test_files()
  {
    const auto fault_of = [](const std::string &path, const auto &action) {
      WritableFile file;
      file.open(path, path == "three");
      action(file);
      return file.fault().substr(0, file.fault().find('\n'));
    };
    compare({{fault_of("three",
                       [](WritableFile &file) {
                         file.write("abc", 0);
                         file.cut(3);
                         errno = EINVAL;
                         file.cut(4);
                       }),
              "three: is shorter than the checkpoint says"},
             {fault_of("/dev/null", [](WritableFile &file) { file.cut(0); }),
              "/dev/null: cannot be cut back: Invalid argument"},
             {fault_of("/dev/null", [](WritableFile &file) { file.sync(); }),
              "/dev/null: cannot be written to the disk: Invalid argument"}});
  }



  void
  test_allocations()
  {
    const Scene          scene{Parameters()};
    const OutputUnits    units(scene.parameters);
    CsvFile<StepRecord>  contact("contact.csv", contact_columns(scene), units);
    CsvFile<EventRow>    events("events.csv", event_columns(scene), units);
    CsvFile<StepAttempt> steps("steps.csv", attempt_columns(), units);
    contact.open(".", "", 0);
    events.open(".", "", 0);
    steps.open(".", "", 0);
    StepRecord record;
    record.time         = 0.1;
    record.energy       = std::nan("");
    const auto add_rows = [&]() {
      const unsigned long before = n_allocations;
      for (unsigned int i = 0; i < 100; ++i)
        {
          contact.add(record);
          events.add(EventRow());
          steps.add(StepAttempt());
        }
      const unsigned long n = n_allocations - before;
      contact.file.flush();
      events.file.flush();
      steps.file.flush();
      return n;
    };
    const bool counts = add_rows() > 0;
    deallog << "allocations are counted " << counts << ", for more rows "
            << add_rows() << std::endl;
  }
} // namespace



void
main_number_text()
{
  initlog();
  test_known_numbers();
  test_reading();
  test_random_numbers();
  test_columns();
  test_files();
  test_allocations();
}
