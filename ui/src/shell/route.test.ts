import { describe, expect, test } from "vitest";
import { textsOf } from "../i18n";
import { LANGUAGES } from "../i18n/languages";
import { hashOf, keyOf, parse, ROUTES, type Route, SCREENS } from "./route";

const PLACES: readonly (readonly [string, Route])[] = [
  ["#/", { screen: "start" }],
  ["#/program/p1", { screen: "studio", program: "p1" }],
  ["#/work/g1", { screen: "work", group: "g1" }],
  ["#/practice", { screen: "practice" }],
  ["#/run/r1", { screen: "replay", run: "r1" }],
  ["#/versions/p1", { screen: "versions", program: "p1", version: null }],
  ["#/versions/p1/v1", { screen: "versions", program: "p1", version: "v1" }],
  ["#/differences/p1/v1/v2", { screen: "differences", program: "p1", before: "v1", after: "v2" }],
  ["#/teacher/files", { screen: "teacher", part: "files" }],
  ["#/lesson/l1", { screen: "lesson", lesson: "l1" }],
  ["#/runs", { screen: "runs" }],
  ["#/compare/r1/r2", { screen: "compare", first: "r1", second: "r2" }],
];

describe("a route", () => {
  test.each(PLACES)("%s is read and written", (hash, route) => {
    expect(parse(hash)).toEqual(route);
    expect(hashOf(route)).toBe(hash);
  });

  test.each(SCREENS)("of the screen %s is read as it is written", (screen) => {
    const { pattern, choices = {} } = ROUTES[screen];
    const names = [...pattern.matchAll(/:(\w+)/g)].map(([, name]) => name ?? "");
    const values = names.map((name) => [name, choices[name]?.at(-1) ?? `a-${name}`]);
    const to = { screen, ...Object.fromEntries(values) } as Route;
    expect(parse(hashOf(to))).toEqual(to);
  });

  test("has a title in every language, whichever its screen", () => {
    for (const language of LANGUAGES) {
      expect(Object.keys(textsOf(language).titles).sort()).toEqual([...SCREENS].sort());
    }
  });

  test("that is unknown or lacks a parameter is the start", () => {
    for (const hash of ["", "#", "#/nowhere", "#/program", "#/program/", "#/differences/p1/v1"]) {
      expect(parse(hash), hash).toEqual({ screen: "start" });
    }
  });

  test("to the teacher's part without a part, or to none there is, leads to the first", () => {
    for (const hash of ["#/teacher", "#/teacher/nowhere"]) {
      expect(parse(hash)).toEqual({ screen: "teacher", part: "lessons" });
    }
  });
});

test("a screen begins anew where its parameters change, but not with another version or part", () => {
  const key = (hash: string) => keyOf(parse(hash));
  expect(key("#/program/p1")).not.toBe(key("#/program/p2"));
  expect(key("#/differences/p/a/b")).not.toBe(key("#/differences/p/a/c"));
  expect(key("#/versions/p/a")).toBe(key("#/versions/p/b"));
  expect(key("#/teacher/lessons")).toBe(key("#/teacher/files"));
});

test("what is remounted for is a parameter of the pattern", () => {
  for (const screen of SCREENS) {
    const { pattern, remount = [] } = ROUTES[screen];
    for (const name of remount) expect(pattern).toMatch(new RegExp(`:${name}\\b`));
  }
});
