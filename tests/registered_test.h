// Tests share programs, since most of what each takes to compile goes into headers that all
// include.
//
// A test file has a namespace of its own, ripstop::test_rods for test_rods.cpp, so that its names
// do not meet those of the others. The namespace ends with
//
//     const RegisteredTest registered("test_rods", runPlain<TestRods>);
//
// where the name is that of the file, and the function says what its main() would do if it were a
// program of its own: make an application or none, and run the test. runWithWidgets() and
// runWithView() are in views/run_with_widgets.h; a file may have a function of its own.
//
// `PROGRAM test_rods ARGUMENTS` is that program then, with the arguments that QtTest takes, and so
// is a link to PROGRAM that is called test_rods. Each runs one test in a process of its own.
#pragma once

#include <QCoreApplication>
#include <QtTest>

namespace ripstop {

using TestMain = int (*)(int argc, char** argv);

class RegisteredTest
{
public:
    RegisteredTest(const char* name, TestMain main);
};

// Without an application.
template <typename Test>
int runPlain(int argc, char** argv)
{
    Test test;
    return QTest::qExec(&test, argc, argv);
}

// With an application that has no windows: what waits for signals, timers or other programs.
template <typename Test>
int runWithCore(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    return runPlain<Test>(argc, argv);
}

} // namespace ripstop
