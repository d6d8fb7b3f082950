// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/slurm/slurm_client.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <sstream>
#include <thread>

#include "core/base/lists.h"
#include "experiments/jobs/slurm/slurm_script.h"

namespace cvo {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFirstContactS = 60.0;   // short, because Slurm may not be installed at all
constexpr double kMaxDelayS = 60.0;       // between two retries
constexpr double kCommandLimitS = 120.0;  // a command that hangs longer is killed
constexpr double kStopCheckIntervalS = 0.2;

double Since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

bool HasAny(const std::string& text, std::span<const char* const> parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const char* part) { return text.find(part) != std::string::npos; });
}

// Messages of Slurm's commands while its controller is unreachable, slow or starting.
bool IsUnreachable(const Captured& captured) {
  static constexpr std::array<const char*, 6> kWords = {"contact slurm controller",
                                                        "timed out",
                                                        "Zero Bytes were transmitted",
                                                        "standby mode",
                                                        "connect failure",
                                                        "Connection refused"};
  return captured.exit_code > 128 || (captured.exit_code != 0 && HasAny(captured.err, kWords));
}

bool IsFailure(const Captured& captured) { return captured.exit_code != 0; }

// Classifies a refusal by the message of sbatch.
SlurmRefusal ClassifyRefusal(const std::string& words) {
  static constexpr std::array<const char*, 3> kQueueFull = {
      "temporarily unable to accept job", "Resource temporarily unavailable", "MaxSubmitJob"};
  static constexpr std::array<const char*, 1> kLimit = {"job submit limit"};
  if (HasAny(words, kQueueFull)) return SlurmRefusal::kQueueFull;
  return HasAny(words, kLimit) ? SlurmRefusal::kLimit : SlurmRefusal::kPermanent;
}

std::string LastLine(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) last = line;
  }
  return last.empty() ? "no answer" : last;
}

// Returns the value from a line "Name   = value" of `scontrol show config`; empty if there is none.
std::string ConfigValue(const std::string& config, const std::string& name) {
  std::istringstream lines(config);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find("= ");
    if (line.starts_with(name + " ") && equals != std::string::npos) return line.substr(equals + 2);
  }
  return "";
}

std::size_t ToCount(const std::string& text) {
  std::istringstream in(text);
  std::size_t count = 0;
  in >> count;
  return count;
}

std::string Escaped(const std::string& path) {
  std::string text;
  for (const char c : path) text += c == '%' ? "%%" : std::string(1, c);
  return text;
}

std::vector<std::string> SbatchCommand(const SlurmArray& array,
                                       const std::vector<std::string>& flags) {
  std::vector<std::string> argv = {"sbatch", "--parsable"};
  argv.insert(argv.end(), flags.begin(), flags.end());
  const std::string script = ShellQuoted((array.folder / "tasks.sh").string());
  argv.insert(argv.end(), {"--job-name=" + array.name, "--requeue", "--open-mode=truncate",
                           "--output=" + Escaped((array.folder / "out").string()) + "/%a",
                           "--wrap=exec sh " + script});
  return argv;
}

}  // namespace

bool IsTaskFinished(const std::string& state) {
  static constexpr std::array<const char*, 10> kFinishedStates = {
      "COMPLETED", "FAILED",    "CANCELLED", "TIMEOUT",  "OUT_OF_MEMORY",
      "NODE_FAIL", "BOOT_FAIL", "PREEMPTED", "DEADLINE", "REVOKED"};
  return std::find(kFinishedStates.begin(), kFinishedStates.end(), state) != kFinishedStates.end();
}

SlurmClient::SlurmClient(double patience_s, EngineHooks hooks)
    : patience_s_(patience_s), hooks_(std::move(hooks)) {}

bool SlurmClient::Pause(double seconds) const {
  const Clock::time_point start = Clock::now();
  while (!hooks_.stop()) {
    const double left_s = seconds - Since(start);
    if (left_s <= 0.0) return true;
    std::this_thread::sleep_for(
        std::chrono::duration<double>(std::min(left_s, kStopCheckIntervalS)));
  }
  return false;
}

Captured SlurmClient::Ask(const std::vector<std::string>& argv, double patience_s,
                          const Judge& silent) const {
  const Clock::time_point start = Clock::now();
  for (double delay_s = 1.0;; delay_s = std::min(2.0 * delay_s, kMaxDelayS)) {
    const Clock::time_point asked = Clock::now();
    Captured captured = Capture(
        argv, [&](const Captured&) { return Since(asked) > kCommandLimitS || hooks_.stop(); });
    const bool answered = !silent(captured);
    if (answered && delay_s > 1.0) hooks_.notice("slurm: responds again");
    if (answered) return captured;
    const std::string words = StrCat(argv.front(), ": ", LastLine(captured.err));
    if (delay_s == 1.0) hooks_.notice(StrCat("slurm: ", words, ": retrying"));
    const double left_s = patience_s - Since(start);
    if (left_s <= 0.0 || !Pause(std::min(delay_s, left_s))) {
      throw SlurmUnreachable(StrCat("Slurm does not respond: ", words));
    }
  }
}

SlurmSetup SlurmClient::Setup() const {
  const std::string config =
      Ask({"scontrol", "show", "config"}, std::min(kFirstContactS, patience_s_), IsFailure).out;
  SlurmSetup setup;
  setup.array_size = ToCount(ConfigValue(config, "MaxArraySize"));
  const std::string scheduler = ConfigValue(config, "SchedulerParameters");
  const std::string key = "max_array_tasks=";
  if (const std::size_t at = scheduler.find(key); at != std::string::npos) {
    setup.array_size = std::min(setup.array_size, ToCount(scheduler.substr(at + key.size())));
  }
  if (setup.array_size == 0) ThrowError("slurm", "job arrays disabled", "MaxArraySize above 0");
  const std::string storage = ConfigValue(config, "AccountingStorageType");
  setup.accounting = !storage.empty() && storage.find("none") == std::string::npos;
  return setup;
}

SlurmQueue SlurmClient::Queue(const std::vector<std::string>& names) const {
  SlurmQueue queue;
  if (names.empty()) return queue;
  const Captured answer =
      Ask({"squeue", "--noheader", "--array", "--states=all", StrCat("--user=", ::geteuid()),
           "--name=" + Joined(names, ","), "--format=%j|%F|%K|%T|%r"},
          patience_s_, IsFailure);
  std::istringstream lines(answer.out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string name;
    std::string number;
    SlurmTask task;
    if (std::getline(fields, name, '|') && std::getline(fields, task.job, '|') &&
        std::getline(fields, number, '|') && std::getline(fields, task.state, '|') &&
        std::getline(fields, task.reason)) {
      queue[{name, ToCount(number)}] = task;
    }
  }
  return queue;
}

std::optional<std::string> SlurmClient::Find(const std::string& name) const {
  for (const auto& [where, task] : Queue({name})) return task.job;
  return std::nullopt;
}

SlurmSubmitted SlurmClient::Submit(const SlurmArray& array,
                                   const std::vector<std::string>& flags) const {
  const std::vector<std::string> argv = SbatchCommand(array, flags);
  const Clock::time_point start = Clock::now();
  for (double delay_s = 1.0;; delay_s = std::min(2.0 * delay_s, kMaxDelayS)) {
    const Clock::time_point asked = Clock::now();
    // If the queue is full, sbatch itself would retry for minutes.
    const Captured answer = Capture(argv, [&](const Captured& so_far) {
      return ClassifyRefusal(so_far.err) == SlurmRefusal::kQueueFull ||
             Since(asked) > kCommandLimitS;
    });
    if (answer.exit_code == 0)
      return {answer.out.substr(0, answer.out.find_first_of(";\n")), "", {}};
    const SlurmRefusal refusal = ClassifyRefusal(answer.err);
    const bool refused = refusal != SlurmRefusal::kPermanent || !IsUnreachable(answer);
    const std::string words = LastLine(answer.err);  // "sbatch: error: ..."
    if (refused && refusal != SlurmRefusal::kQueueFull) return {"", words, refusal};
    // The array may have been accepted even so, if only the answer was lost.
    if (const std::optional<std::string> job = Find(array.name)) return {*job, "", {}};
    if (refused) return {"", words, refusal};
    if (Since(start) > patience_s_ || !Pause(delay_s)) {
      throw SlurmUnreachable(StrCat("Slurm does not respond: ", words));
    }
  }
}

void SlurmClient::Cancel(const std::vector<std::string>& jobs) const {
  if (jobs.empty()) return;
  std::vector<std::string> argv = {"scancel", "--quiet"};
  argv.insert(argv.end(), jobs.begin(), jobs.end());
  Ask(argv, patience_s_, IsUnreachable);
}

std::string SlurmClient::AccountedState(const std::string& job, std::size_t number) const {
  const Captured answer = Ask({"sacct", "--noheader", "--allocations", "--parsable2",
                               "--format=State", StrCat("--jobs=", job, "_", number)},
                              patience_s_, IsUnreachable);
  return answer.exit_code == 0 && !answer.out.empty() ? LastLine(answer.out) : "";
}

}  // namespace cvo
