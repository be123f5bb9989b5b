import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { plan as en } from "./en/plan";
import { plan as ptBR } from "./pt-BR/plan";

test.each([
  ["lesson.pt-BR.md", ptBR],
  ["lesson.md", en],
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
