import { OWN_WORLD, type Setup, type VersionSummary, worldTitle } from "../api/model";
import type { Language, Texts } from "../i18n";
import { decimal } from "../i18n/format";
import { calibratedTitle } from "../run/real/calibrated_robots";
import { ROOM_WORLD } from "../run/real/real_robot";
import { robotOf, worlds } from "../shell/session";
import { realismOf } from "../studio/program/setup";

/** A changed part of where and how a program runs, in words. */
export interface SetupChange {
  readonly what: string;
  readonly before: string;
  readonly after: string;
}

/** What differs between the setups of two versions; nothing where an earlier release saved one of them. */
export function setupChanges(
  before: Setup | null | undefined,
  after: Setup | null | undefined,
  texts: Texts,
  language: Language,
): SetupChange[] {
  if (!before || !after) return [];
  const [old, now] = [partsOf(before, texts, language), partsOf(after, texts, language)];
  return now.flatMap(([what, value], index) => {
    const was = old[index]?.[1] ?? "";
    return was === value ? [] : [{ what, before: was, after: value }];
  });
}

/** What a step changed besides blocks: "Mundo: Labirinto", "Dica 2 aberta". */
export function setupFacts(
  before: VersionSummary,
  after: VersionSummary,
  texts: Texts,
  language: Language,
): string[] {
  const { archive } = texts;
  const changes = setupChanges(before.setup, after.setup, texts, language);
  const facts = changes.map((one) => archive.setupFact({ what: one.what, now: one.after }));
  const [had, has] = [before.setup?.n_hints ?? 0, after.setup?.n_hints ?? 0];
  if (has === had + 1) facts.push(archive.hintOpened({ to: has }));
  else if (has > had) facts.push(archive.hintsOpened({ from: had + 1, to: has }));
  return facts.length === 0 && after.setup_only ? [unnamed(after, texts)] : facts;
}

/** Of a version with other setup and equal blocks, where no named part differs. */
function unnamed({ setup }: VersionSummary, { archive, run, world }: Texts): string {
  return setup?.world === OWN_WORLD
    ? archive.setupFact({ what: run.world, now: world.own })
    : archive.setup;
}

/** Each part of a setup with its name. */
function partsOf(setup: Setup, texts: Texts, language: Language): [string, string][] {
  const { debug, archive, run } = texts;
  return [
    [run.world, worldLabel(setup.world, texts, language)],
    [archive.start, startText(setup, texts, language)],
    [debug.model, modelText(setup, texts)],
    [archive.robot, debug[realismOf(setup)]],
    [debug.speed, debug.times({ factor: decimal(setup.speed, setup.speed < 1 ? 2 : 0, language) })],
  ];
}

function modelText({ model, calibrated_robot: calibrated }: Setup, { calibration }: Texts): string {
  if (calibrated) return calibratedTitle(calibrated) ?? calibration.missing;
  return robotOf(model)?.title ?? model;
}

/** The name of a world: of one that ships, or of the group's own. */
export function worldLabel(name: string, texts: Texts, language: Language): string {
  if (name === OWN_WORLD) return texts.world.own;
  if (name === ROOM_WORLD) return texts.robot.room;
  const world = worlds.value.find((one) => one.name === name);
  return world ? worldTitle(world, language) : name;
}

function startText({ start }: Setup, { archive }: Texts, language: Language): string {
  if (!start) return archive.worldStart;
  const [x, y] = [decimal(start.x_m, 2, language), decimal(start.y_m, 2, language)];
  return archive.ownStart({ x, y, heading: decimal(start.heading_deg, 0, language) });
}
