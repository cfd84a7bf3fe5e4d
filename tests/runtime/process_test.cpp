#include "runtime/process.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <vector>

#include <unistd.h>

namespace gnomon {
namespace {

using namespace std::chrono_literals;

Child::Serve misbehave() {
    return [count = 0](const std::string& request) mutable -> std::string {
        if (request == "crash") std::raise(SIGABRT); // which sanitizers leave alone
        if (request == "leave") ::_exit(3);
        if (request == "hang") std::this_thread::sleep_for(1h);
        if (request == "throw") throw std::runtime_error("thrown on request");
        return request + std::to_string(++count);
    };
}

TEST(process, answers_one_request_after_the_other) {
    Child child(misbehave);
    for (const char* expected : {"a1", "a2", "a3"}) {
        child.send("a");
        EXPECT_TRUE(child.busy());
        const Answer answer = child.receive(60);
        EXPECT_EQ(answer.kind, Answer::Kind::message);
        EXPECT_EQ(answer.text, expected);
        EXPECT_FALSE(child.busy());
    }
}

TEST(process, long_messages_arrive_whole) {
    Child child(misbehave);
    const std::string text(std::size_t{5} << 20, 'x');
    child.send(text);
    EXPECT_EQ(child.receive(60).text, text + "1");
}

TEST(process, an_exception_is_an_answer_and_the_child_lives_on) {
    Child child(misbehave);
    child.send("throw");
    const Answer answer = child.receive(60);
    EXPECT_EQ(answer.kind, Answer::Kind::error);
    EXPECT_EQ(answer.text, "thrown on request");
    child.send("a");
    EXPECT_EQ(child.receive(60).text, "a1");
}

TEST(process, an_exception_at_the_start_answers_the_first_request) {
    Child child([]() -> Child::Serve { throw std::runtime_error("no device"); });
    child.send("a");
    const Answer answer = child.receive(60);
    EXPECT_EQ(answer.kind, Answer::Kind::error);
    EXPECT_EQ(answer.text, "no device");
}

TEST(process, a_death_says_how_and_stays) {
    Child child(misbehave);
    child.send("leave");
    EXPECT_EQ(child.receive(60).text, "exit code 3");
    child.send("a"); // no SIGPIPE
    const Answer answer = child.receive(60);
    EXPECT_EQ(answer.kind, Answer::Kind::death);
    EXPECT_EQ(answer.text, "exit code 3");
}

TEST(process, a_crash_is_named_by_its_signal) {
    Child child(misbehave);
    child.send("crash");
    const Answer answer = child.receive(60);
    EXPECT_EQ(answer.kind, Answer::Kind::death);
    EXPECT_EQ(answer.text, "signal 6 (Aborted)");
}

TEST(process, one_that_hangs_is_late_until_it_is_killed) {
    Child child(misbehave);
    child.send("hang");
    EXPECT_EQ(child.receive(0.05).kind, Answer::Kind::late);
    EXPECT_TRUE(child.busy());
    child.kill();
    const Answer answer = child.receive(60);
    EXPECT_EQ(answer.kind, Answer::Kind::death);
    EXPECT_EQ(answer.text, "signal 9 (Killed)");
}

TEST(process, the_one_that_is_done_is_found) {
    std::vector<Child> children;
    for (int i = 0; i < 3; ++i) children.emplace_back(misbehave);
    EXPECT_EQ(wait_for_any(children, 0.01), children.size()) << "nobody was asked";
    children[0].send("hang");
    children[2].send("a");
    EXPECT_EQ(wait_for_any(children, 60), 2u);
    EXPECT_EQ(children[2].receive(60).text, "a1");
    EXPECT_EQ(wait_for_any(children, 0.05), children.size());
}

TEST(process, a_child_dies_with_its_object) {
    pid_t pid = 0;
    {
        Child child(misbehave);
        child.send("hang");
        pid = child.pid();
        EXPECT_EQ(::kill(pid, 0), 0);
    }
    EXPECT_NE(::kill(pid, 0), 0);
}

} // namespace
} // namespace gnomon
