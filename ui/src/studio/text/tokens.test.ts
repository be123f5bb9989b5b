import { expect, test } from "vitest";
import { JSON_TOKENS, PYTHON_TOKENS, tokens } from "./tokens";

type Piece = string | { props: { class: string; children: string } };

const pieces = (text: string, pattern: RegExp) =>
  (tokens(text, pattern) as Piece[])
    .filter((piece) => piece !== "")
    .map((piece) =>
      typeof piece === "string" ? piece : [piece.props.class.slice(7), piece.props.children],
    );

test("a line of Python has words, numbers, texts and comments", () => {
  expect(pieces('for i in steps(1, 2.5): say("# no")  # yes "x"', PYTHON_TOKENS)).toEqual([
    ["word", "for"],
    " i ",
    ["word", "in"],
    " steps(",
    ["number", "1"],
    ", ",
    ["number", "2.5"],
    "): say(",
    ["text", '"# no"'],
    ")  ",
    ["comment", '# yes "x"'],
  ]);
});

test("a text in three quotes may have several lines", () => {
  expect(pieces('"""a\nfor"""\nx', PYTHON_TOKENS)).toEqual([["text", '"""a\nfor"""'], "\nx"]);
});

test("names in JSON are told from texts", () => {
  expect(pieces('{"a": "b"}', JSON_TOKENS)).toEqual([
    "{",
    ["name", '"a"'],
    ": ",
    ["text", '"b"'],
    "}",
  ]);
});

test("no letter is lost, and a very long text comes as it is", () => {
  const text = "x = \"open\nrobot.say('a\\'b')\n".repeat(20);
  const whole = pieces(text, PYTHON_TOKENS).map((piece) =>
    Array.isArray(piece) ? piece[1] : piece,
  );
  expect(whole.join("")).toBe(text);
  const long = "a = 1\n".repeat(20_000);
  expect(tokens(long, PYTHON_TOKENS)).toBe(long);
});
