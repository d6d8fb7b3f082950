// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/pictures/browser.h"

#include <poll.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/jobs/child_process.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr double kLimit_s = 120.0;
// Virtual time that a page may take before its content is read. It passes as fast as the page
// allows, without waiting while the page is idle.
constexpr int kPageTime_ms = 100'000;

// The last line that the browser printed, for error messages.
std::string LastLine(const fs::path& log) {
  std::string text = fs::exists(log) ? ReadFileBytes(log) : "";
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return Quoted(text.substr(text.rfind('\n') + 1));
}

TaskEnd WaitFor(ChildProcess& process) {
  while (true) {
    pollfd ended{process.poll_fd(), POLLIN, 0};
    constexpr int kEvery_ms = 500;
    ::poll(&ended, 1, kEvery_ms);
    if (const auto end = process.Poll()) return *end;
  }
}

}  // namespace

Browser::Browser(fs::path scratch) : program_("/usr/bin/chromium"), scratch_(std::move(scratch)) {
  const char* chosen = std::getenv("CLUSTERVO_BROWSER");
  if (chosen != nullptr && *chosen != '\0') program_ = chosen;
  if (::access(program_.c_str(), X_OK) != 0 || fs::is_directory(program_)) {
    ThrowError(program_.string(), "a program that cannot be run",
               "a Chromium (Debian: apt install chromium; elsewhere: CLUSTERVO_BROWSER=PATH)");
  }
}

std::string Browser::Run(const std::string& page) const {
  return Start(page, "--dump-dom", scratch_ / "page.out");
}

std::string Browser::Print(const std::string& page) const {
  const fs::path pdf = scratch_ / "page.pdf";
  fs::remove(pdf);
  return Start(page, "--print-to-pdf=" + pdf.string(), pdf);
}

std::string Browser::Start(const std::string& page, const std::string& flag,
                           const fs::path& out) const {
  const fs::path file = scratch_ / "page.html";
  const fs::path profile = scratch_ / "profile";
  const fs::path log = scratch_ / "browser.log";
  fs::remove_all(profile);
  WriteFileBytes(file, page);
  // The shell separates the browser's standard output from its messages, which go to the log.
  Task task{"browser",
            {"/bin/sh",
             "-c",
             "out=$1; shift; exec \"$@\" >\"$out\"",
             "sh",
             (scratch_ / "page.out").string(),
             program_.string(),
             "--headless",
             "--disable-gpu",
             "--no-first-run",
             "--disable-background-networking",
             "--disable-component-update",
             "--disable-sync",
             "--disable-extensions",
             "--disable-crash-reporter",
             "--disable-dev-shm-usage",
             "--hide-scrollbars",
             "--force-device-scale-factor=1",
             "--host-resolver-rules=MAP * ~NOTFOUND",
             "--no-pdf-header-footer",
             "--user-data-dir=" + profile.string(),
             StrCat("--virtual-time-budget=", kPageTime_ms),
             flag},
            log,
            kLimit_s,
            0.0};
  if (::geteuid() == 0) task.argv.emplace_back("--no-sandbox");
  task.argv.push_back("file://" + file.string());
  ChildProcess process(task);
  const TaskEnd end = WaitFor(process);
  if (!end.ok) {
    ThrowError(program_.string(), StrCat(end.message, ", last line ", LastLine(log)),
               "a rendered page");
  }
  if (!fs::exists(out)) {
    ThrowError(program_.string(), StrCat("nothing written, last line ", LastLine(log)),
               out.filename().string());
  }
  return ReadFileBytes(out);
}

}  // namespace cvo
