// SPDX-License-Identifier: MIT
#include "show/background_choice.h"

#include <atomic>
#include <thread>
#include <utility>

#include "core/interrupt.h"

namespace ballpit {

struct BackgroundChoice::Job {
  Job(Scene its_scene, std::vector<GivenOption> its_given, double its_budget)
      : scene(std::move(its_scene)), given(std::move(its_given)), budget(its_budget) {
    thread = std::jthread([this](std::stop_token stop) { run(std::move(stop)); });
  }

  void run(std::stop_token stop) {
    try {
      result.choice = choose({.scene = scene, .given = given, .budget = budget, .stop = std::move(stop)});
    } catch (const Interrupted&) {
      // nobody wants it any more
    } catch (const std::exception& error) {
      result.failure = error.what();
    }
    is_done = true;
  }

  const Scene scene;
  const std::vector<GivenOption> given;
  const double budget;
  Result result;
  std::atomic<bool> is_done = false;
  std::jthread thread;  // last, since it uses the others
};

BackgroundChoice::BackgroundChoice() = default;
BackgroundChoice::~BackgroundChoice() { abandon(); }

void BackgroundChoice::begin(Scene scene, std::vector<GivenOption> given, double budget) {
  abandon();
  job_ = std::make_unique<Job>(std::move(scene), std::move(given), budget);
}

void BackgroundChoice::abandon() {
  std::erase_if(abandoned_, [](const std::unique_ptr<Job>& job) { return job->is_done.load(); });
  if (!job_) return;
  job_->thread.request_stop();
  abandoned_.push_back(std::move(job_));
}

std::optional<BackgroundChoice::Result> BackgroundChoice::result() {
  return job_ && job_->is_done ? wait() : std::nullopt;
}

std::optional<BackgroundChoice::Result> BackgroundChoice::wait() {
  if (!job_) return std::nullopt;
  job_->thread.join();
  Result result = std::move(job_->result);
  job_.reset();
  return result;
}

}  // namespace ballpit
