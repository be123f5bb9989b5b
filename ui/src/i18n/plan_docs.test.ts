import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { textsOf } from ".";

test.each([
  ["lesson.pt-BR.md", textsOf("pt-BR").plan],
  ["lesson.md", textsOf("en").plan],
])("%s says what the page says of the lesson", (name, plan) => {
  const page = readFileSync(`../docs/${name}`, "utf8").replace(/\s+/g, " ");
  const { title, about, steps, robots, roles, deaf: inclusion, projector } = plan;
  const said = [
    title,
    about,
    ...Object.values(steps).flatMap((step) => Object.values(step)),
    robots,
    roles,
    ...[inclusion, projector].flatMap((part) => [part.title, ...part.points]),
  ];
  expect(said.filter((text) => !page.includes(text))).toEqual([]);
});
