import { computed, signal } from "@preact/signals";
import { authoringApi } from "../../api/authoring";
import { api } from "../../api/client";
import { DEFAULT_WORLD } from "../../api/declared";
import {
  type Fault,
  OWN_WORLD,
  type OwnActivityDraft,
  type OwnActivityToEdit,
  type Proposal,
  type Trials,
  type Version,
} from "../../api/model";
import type { Level } from "../../blocks/definition";
import { levelNeeded } from "../../blocks/toolbox/level_needed";
import { worlds } from "../../shell/session";
import {
  type Check,
  type CheckKind,
  type Choices,
  type Chosen,
  checksOf,
  choicesOf,
  proposed,
} from "./check_choices";

/** The fields of the form with texts. */
export interface Written {
  readonly title: string;
  readonly story: string;
  readonly criteria: string;
  readonly hints: readonly [string, string, string];
  readonly question: string;
}

type Stage = Pick<OwnActivityDraft, "solution" | "world">;

const NOTHING: Written = { title: "", story: "", criteria: "", hints: ["", "", ""], question: "" };

/** State of the activity form: solution, checks, texts, and the result of the trial. */
export class ActivityEditor {
  readonly id: string | null;
  readonly written = signal<Written>(NOTHING);
  readonly level = signal<Level>(1);
  readonly minutes = signal(10);
  readonly showsPath = signal(true);
  /** Inputs of the solution, separated by commas. */
  readonly inputs = signal({ gestures: "", answers: "" });
  readonly stage = signal<Stage | null>(null);
  /** The lowest level that offers the blocks of the solution. */
  readonly levelOfSolution = signal<Level>(1);
  readonly proposal = signal<Proposal | null>(null);
  readonly faults = signal<readonly Fault[]>([]);
  readonly choices = signal<Choices | null>(null);
  readonly trials = signal<Trials | null>(null);
  private others: readonly Check[] = [];

  /** The activity that the form would save; null without a solution that runs. */
  readonly draft = computed<OwnActivityDraft | null>(() => {
    const { value: stage } = this.stage;
    const { value: choices } = this.choices;
    if (!stage || !this.proposal.value || !choices) return null;
    const { hints, ...texts } = this.written.value;
    return {
      ...texts,
      ...stage,
      ...this.inputLists(),
      hints: hints.filter((hint) => hint.trim()),
      level: this.level.value,
      minutes: this.minutes.value,
      shows_path: this.showsPath.value,
      checks: [...checksOf(choices), ...this.others],
    };
  });

  constructor(activity: OwnActivityToEdit | null) {
    this.id = activity?.id ?? null;
    if (activity) this.begin(activity);
  }

  write(changes: Partial<Written>): void {
    this.written.value = { ...this.written.peek(), ...changes };
  }

  choose(kind: CheckKind, changes: Partial<Chosen>): void {
    const before = this.choices.peek();
    const chosen = before?.[kind];
    if (chosen) this.choices.value = { ...before, [kind]: { ...chosen, ...changes } };
    this.trials.value = null;
  }

  /** Sets a program as the solution, in the world of its runs. Returns false for a program without commands. */
  async setProgram(id: string): Promise<boolean> {
    const { version } = await api.program(id);
    if (!version?.document || isEmpty(version.document)) return false;
    this.levelOfSolution.value = levelNeeded(version.workspace);
    if (this.level.peek() < this.levelOfSolution.peek())
      this.level.value = this.levelOfSolution.peek();
    await this.measure({ solution: version.document, world: worldOf(version) });
    return true;
  }

  async setWorld(name: string): Promise<void> {
    const { value: stage } = this.stage;
    if (stage) await this.measure({ ...stage, world: name });
  }

  /** Runs the solution again, such as with other inputs. */
  async measure(stage: Stage | null = this.stage.peek()): Promise<void> {
    if (!stage) return;
    this.trials.value = null;
    const { proposal, faults } = await authoringApi.measure({ ...stage, ...this.inputLists() });
    this.stage.value = stage;
    this.faults.value = faults;
    this.proposal.value = proposal;
    if (proposal) this.choices.value = proposed(proposal, this.choices.peek() ?? {});
  }

  async tryOut(): Promise<void> {
    const { value: draft } = this.draft;
    if (draft)
      this.trials.value = await authoringApi.tryOut({ ...draft, title: draft.title || "-" });
  }

  private begin(activity: OwnActivityToEdit): void {
    const [first = "", second = "", third = ""] = activity.hints;
    const { title, story, criteria, question } = activity;
    this.written.value = { title, story, criteria, question, hints: [first, second, third] };
    this.level.value = activity.level as Level;
    this.minutes.value = activity.minutes ?? 10;
    this.showsPath.value = activity.shows_path;
    this.inputs.value = {
      gestures: activity.gestures.join(", "),
      answers: activity.answers.join(", "),
    };
    this.stage.value = { solution: activity.solution, world: activity.world };
    const found = choicesOf(activity.checks);
    this.others = found.others;
    this.choices.value = found.formChoices;
  }

  private inputLists() {
    const { gestures, answers } = this.inputs.value;
    return { gestures: listed(gestures), answers: listed(answers) };
  }
}

const listed = (text: string) =>
  text
    .split(/[,;]/)
    .map((part) => part.trim())
    .filter(Boolean);

const isEmpty = (document: object) => {
  const { commands } = document as { commands?: unknown[] };
  return !commands || commands.length === 0;
};

/** The world of a version's runs: its name, or a document if the group made the world or moved the start. */
function worldOf({ setup, world }: Version): Stage["world"] {
  const name = setup?.world ?? (world ? OWN_WORLD : DEFAULT_WORLD);
  const shipped = worlds.peek().find((one) => one.name === name);
  const document = name === OWN_WORLD ? world : shipped;
  if (!document) return DEFAULT_WORLD;
  if (name !== OWN_WORLD && !setup?.start) return name;
  return { ...document, ...(setup?.start ? { start: setup.start } : {}) } as unknown as Record<
    string,
    unknown
  >;
}
