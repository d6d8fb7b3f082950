// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <new>
#include <opencv2/core/utility.hpp>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/utf8.h"
#include "core/files/text_file.h"
#include "experiments/cli/command.h"

namespace cvo {
namespace {

// Makes everything that is printed to a stream plain text for as long as this object exists.
// Characters that a terminal would interpret (escape sequences, line erasure, changes of writing
// direction), which names of files, keys and suites may contain, become U+FFFD. Text is passed on
// in whole lines; an incomplete line is passed on when the stream is flushed.
class CleanOutput : public std::streambuf {
 public:
  explicit CleanOutput(std::ostream& stream) : stream_(stream), target_(stream.rdbuf(this)) {}
  ~CleanOutput() override;
  CleanOutput(const CleanOutput&) = delete;
  CleanOutput& operator=(const CleanOutput&) = delete;

 protected:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  // Cleans and passes on the first `size` waiting bytes. Returns whether all of them could be
  // written.
  bool Pass(std::size_t size);

  std::ostream& stream_;
  std::streambuf* target_;
  std::mutex mutex_;     // several threads print notices
  std::string waiting_;  // the incomplete last line
};

CleanOutput::~CleanOutput() {
  Pass(waiting_.size());
  stream_.rdbuf(target_);
}

CleanOutput::int_type CleanOutput::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof()))
    return traits_type::not_eof(character);
  const char byte = traits_type::to_char_type(character);
  return xsputn(&byte, 1) == 1 ? character : traits_type::eof();
}

std::streamsize CleanOutput::xsputn(const char* text, std::streamsize size) {
  const std::lock_guard lock(mutex_);
  waiting_.append(text, static_cast<std::size_t>(size));
  return Pass(waiting_.rfind('\n') + 1) ? size : 0;  // npos + 1 = 0
}

int CleanOutput::sync() {
  const std::lock_guard lock(mutex_);
  const bool passed = Pass(waiting_.size());
  return target_->pubsync() == 0 && passed ? 0 : -1;
}

bool CleanOutput::Pass(std::size_t size) {
  const std::string clean = PrintableLines(waiting_.substr(0, size));
  waiting_.erase(0, size);
  const auto length = static_cast<std::streamsize>(clean.size());
  return target_->sputn(clean.data(), length) == length;
}

constexpr int kBadInput = 1;
constexpr int kInternal = 3;

// Message for memory exhaustion, with the memory limit if one was set, as for jobs. It counts as a
// failure of the input, not as an internal error.
std::string OutOfMemory() {
  rlimit limit{};
  const bool limited = ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  if (!limited) return "out of memory";
  return StrCat("out of memory: memory limit of ", static_cast<double>(limit.rlim_cur) / 1e6,
                " MB");
}

// Prints the message as one line on stderr, whatever it contains. Returns the exit code.
int Fail(const std::string& message, int exit_code) {
  std::cerr << "clustervo: error: " << Shortened(Printable(message)) << '\n';
  return exit_code;
}

std::string CommandName(const CLI::App& app) {
  const CLI::App* above = app.get_parent();
  return above == nullptr ? app.get_name() : CommandName(*above) + " " + app.get_name();
}

// Spellings of version 0.2, and what took their place.
std::string PresentName(const std::string& command, const std::string& word) {
  static const std::map<std::string, std::string> kPresent = {
      {"clustervo variants", "list variants"},
      {"clustervo options", "list options"},
      {"clustervo eval --estimate", "eval trajectory or eval boxes"},
      {"clustervo synth list", "list scenes"},
      {"clustervo synth generate", "synth render FAMILY@SEED"},
      {"clustervo experiment list", "list suites"},
      {"clustervo experiment plan", "experiment run SUITE -o DIR --dry-run"},
      {"clustervo experiment status",
       "experiment table DIR, or experiment run SUITE -o DIR --dry-run"},
      {"clustervo synth preview", "synth render SCENE -o FILE --preview"},
      {"clustervo import", "info --left L --right R --calib C -o FOLDER"},
      {"clustervo experiment times", "experiment table --times"},
      {"clustervo compare", "experiment compare"},
      {"clustervo check --exact", "check, exact unless --tolerant"},
      {"clustervo figures", "plot DIR"}};
  const auto found = kPresent.find(command + " " + word);
  return found == kPresent.end() ? "" : ", now clustervo " + found->second;
}

// Throws UsageError for a word that is no subcommand where one must be, and for a flag that the
// command does not have, with what was probably meant. The parser would only call them unexpected.
void CheckNames(int argc, char** argv, const CLI::App& program) {
  const CLI::App* app = &program;
  bool flagged = false;
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    const std::string word = argv[i];
    const bool is_flag = word.starts_with("--");
    flagged = flagged || word.starts_with('-');
    std::vector<std::string> names;
    if (is_flag) {
      for (const CLI::Option* option : app->get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      }
    } else {
      const auto below = app->get_subcommands([](const CLI::App*) { return true; });
      const auto found = std::find_if(below.begin(), below.end(), [&](const CLI::App* command) {
        return command->get_name() == word;
      });
      if (found != below.end()) app = *found;
      if (found != below.end() || below.empty() || flagged || word.empty()) continue;
      for (const CLI::App* command : below) {
        if (!command->get_group().empty()) names.push_back(command->get_name());
      }
    }
    const std::string name = is_flag ? word.substr(0, word.find('=')) : word;
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string command = CommandName(*app);
    const std::string present = PresentName(command, name);
    const std::string meant = present.empty() ? DidYouMean(name, names) : present;
    if (is_flag && meant.empty()) continue;  // the value of a flag, or left to ExplainUsage
    throw UsageError(StrCat(command,
                            is_flag ? " has no flag " + name : " has no subcommand " + Quoted(name),
                            meant.empty() ? ", expected " + OneOfKnown(name, names) : meant,
                            " (see ", command, " --help)"));
  }
}

// Throws UsageError for an empty output name, which is what shells make of an unset variable.
void CheckOutputName(const CLI::App& program) {
  const CLI::App* app = &program;
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  const CLI::Option* output = app->get_option_no_throw("--output");
  if (output == nullptr || output->count() == 0 || !output->results().front().empty()) return;
  throw UsageError(StrCat("--output: found an empty name, expected that of a folder or file (see ",
                          CommandName(*app), " --help)"));
}

int ExplainUsage(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App* app = &program;
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  if (app->get_require_subcommand_min() > 0 && program.remaining_size(true) == 0) {
    std::cerr << program.help();
    return kUsage;
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::string extra = program.remaining(true).front();
    const std::string command = CommandName(*app);
    const std::string problem =
        extra.starts_with('-') ? " has no flag " + extra : ": unexpected argument " + Quoted(extra);
    return Fail(StrCat(command, problem, " (see ", command, " --help)"), kUsage);
  }
  return Fail(StrCat(error.what(), " (see ", CommandName(*app), " --help)"), kUsage);
}

// A wrong value of a flag is a usage error; anything wrong with a file is bad input.
int ExitCodeOf(std::string_view message) {
  return message.starts_with("--") || message.starts_with("option --") ? kUsage : kBadInput;
}

// Opens /dev/null in place of closed standard streams, because the next opened files would take
// their descriptors. It is opened read-only, so writing to such a stream still fails.
void ReplaceClosedStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", O_RDONLY);
  }
}

// Keeps freed memory. Each frame needs some megabytes for a short time, and malloc would return
// them to the system: clearing the pages that it gets back takes a third of the CPU time of a run.
void KeepFreedMemory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

// Reports output that could not be written, because of a full disk or a closed stream.
int CheckPrinted(int exit_code) {
  std::cout.flush();
  if (std::cout) return exit_code;
  const int code = Fail("standard output: not all output could be written", kBadInput);
  return exit_code == 0 ? code : exit_code;
}

int Main(int argc, char** argv) {
  cv::setNumThreads(1);  // the program has its own threads; OpenCV's break determinism

  CLI::App program(
      "Stereo visual odometry that also tracks moving rigid bodies, on recorded and rendered "
      "sequences, scored with explicitly defined metrics.");
  program.name("clustervo");
  program.set_version_flag("--version", VersionText);
  program.footer(
      "Start with: clustervo info SEQUENCE, then clustervo run SEQUENCE -o OUT.\n"
      "Exit codes: 0 success, 1 bad input or failure, 2 usage error, 3 internal error, 130 "
      "interrupted.");
  const Command chosen = Group(
      program, {AddRunCommand(program), AddDetectCommand(program), AddEvalCommand(program),
                AddInfoCommand(program), AddCrfCommand(program), AddListCommand(program),
                AddSynthCommand(program), AddExperimentCommand(program), AddCheckCommand(program),
                AddOverlayCommand(program), AddReportCommand(program), AddPlotCommand(program),
                AddExplainCommand(program)});
  try {
    CheckNames(argc, argv, program);
    program.parse(argc, argv);
    CheckOutputName(program);
  } catch (const CLI::ParseError& error) {
    // --help and --version arrive as exceptions, too.
    return error.get_exit_code() == 0 ? program.exit(error) : ExplainUsage(program, error);
  }
  return chosen.run();
}

}  // namespace
}  // namespace cvo

int main(int argc, char** argv) {
  const cvo::CleanOutput out(std::cout);
  const cvo::CleanOutput err(std::cerr);
  try {
    cvo::ReplaceClosedStreams();
    cvo::KeepFreedMemory();
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond `ulimit -f` fails instead
    return cvo::CheckPrinted(cvo::Main(argc, argv));
  } catch (const cvo::UsageError& error) {
    return cvo::Fail(error.what(), cvo::kUsage);
  } catch (const std::filesystem::filesystem_error& error) {
    return cvo::Fail(cvo::StrCat(error.path1().string(), ": ", error.code().message()),
                     cvo::kUsage);
  } catch (const cvo::Error& error) {
    return cvo::Fail(error.what(), cvo::ExitCodeOf(error.what()));
  } catch (const std::bad_alloc&) {
    return cvo::Fail(cvo::OutOfMemory(), cvo::kBadInput);
  } catch (const std::exception& error) {
    const auto* opencv = dynamic_cast<const cv::Exception*>(&error);
    if (opencv != nullptr && opencv->code == cv::Error::StsNoMem) {
      return cvo::Fail(cvo::OutOfMemory(), cvo::kBadInput);
    }
    return cvo::Fail(cvo::StrCat("internal: ", error.what()), cvo::kInternal);
  } catch (...) {
    return cvo::Fail("internal: unknown exception", cvo::kInternal);
  }
}
