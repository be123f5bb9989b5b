import { computed, effect, signal, untracked } from "@preact/signals";
import { cloudsApi } from "../../api/clouds";
import type { CloudProgressEvent, CloudRow, RunOptions, SavedState, Setup } from "../../api/model";
import type { Fault as BlockFault } from "../../editor";
import * as robot from "../../run/live";
import { chosenRobot } from "../../run/real/real_robot";
import type { Bundle } from "../../scene/bundle/bundle";
import { level } from "../../shell/level";
import { cloud as newest, report } from "../../shell/session";
import { hasCommands, type OpenProgram } from "../program/open_program";
import { REALISM_PRESETS } from "../program/setup";
import type { StartChoice } from "../start_choice";
import type { WorldControl } from "../world_control";

type CloudInputs = Required<NonNullable<RunOptions["cloud"]>>;

/** What a cloud needs of the studio. */
interface Studio {
  readonly open: OpenProgram;
  readonly worlds: WorldControl;
  readonly start: StartChoice;
  readonly mine: { peek(): boolean };
  /** Saves the program as it is on the screen; null if it has faults, which are then shown. */
  savedVersion(): Promise<SavedState | null>;
  /** Runs the program with further options. */
  drive(options: Partial<RunOptions>): Promise<void>;
}

/** The robots of one program, as they arrive. */
export interface Cloud {
  readonly id: string;
  /** The program, its world, start and robot: with others the cloud is stale. */
  readonly of: string;
  readonly n: number;
  readonly rows: readonly CloudRow[];
  /** The last event; null while robots are under way. */
  readonly end: CloudProgressEvent | null;
  /** How many did it in the cloud before, with the same case; null without one. */
  readonly before: number | null;
  /** The mission's case that they drive, and the run whose signs and answers they read. */
  readonly reads: CloudInputs;
}

const N_ROBOTS = 50;
/** Wait before the processes start, so that they do not delay the opening of the program; ms. */
const WARM_UP_MS = 3000;

/** The same program in many realistic robots: how firm is it? */
export class CloudControl {
  readonly now = signal<Cloud | null>(null);
  readonly isRunning = computed(() => this.now.value !== null && this.now.value.end === null);
  /** Whether the program, its world or its robot has changed since. */
  readonly isStale = computed(
    () => this.now.value !== null && this.now.value.of !== this.subject(),
  );
  /** The robots that have arrived; once the end tells which of them did it, by that. */
  readonly rows = computed<readonly CloudRow[]>(() => {
    const { rows = [], end } = this.now.value ?? {};
    return end ? rows.map((row) => ({ ...row, well: end.good.includes(row.seed) })) : rows;
  });
  readonly bundle = computed<Bundle | null>(() => {
    if (!this.now.value || chosenRobot.value) return null;
    const paths = this.rows.value.map(({ seed, well, path }) => ({ id: seed, well, path }));
    return { paths, isFaint: this.isStale.value };
  });
  /** What stopped most of the robots, at its block; null while it is unknown, or the program is changed. */
  readonly advice = computed<BlockFault | null>(() => {
    const end = this.isStale.value ? null : this.now.value?.end;
    if (!end?.block) return null;
    return { block: end.block, message: end.text, remedy: "", isQuiet: true };
  });

  /** The request that starts the cloud; a stop that overtook it would stop nothing. */
  private started: Promise<unknown> = Promise.resolve();
  /** The last run in which people gave signs and answers, and the last one of a robot, which was given them. */
  private answered: string | null = null;
  private watched: string | null = null;

  constructor(private readonly studio: Studio) {}

  /** Listens to the robots; starts their processes before they are needed. Returns the function that ends both. */
  listen(): () => void {
    const timer = window.setTimeout(() => this.warmUp(), WARM_UP_MS);
    const stop = effect(() => {
      const { value: event } = newest;
      if (event) untracked(() => this.receive(event));
    });
    return () => {
      window.clearTimeout(timer);
      stop();
      this.stop();
    };
  }

  /** Starts the processes of the robots for a program that has blocks, in a level with the button. */
  warmUp(): void {
    const isOffered = level.peek() > 1 && !chosenRobot.peek();
    if (isOffered && hasCommands(this.studio.open.content.peek()?.document)) {
      cloudsApi.prepare().catch(() => {}); // then the first robots come a second later
    }
  }

  /** Drives the robots in a case of the mission: at first in that of the group's own runs, then in the one chosen. */
  async begin(chosen?: number): Promise<void> {
    const { studio } = this;
    const last = this.now.peek();
    const number = chosen ?? last?.reads.case ?? 1;
    const version = await studio.savedVersion();
    if (!version) return;
    const id = crypto.randomUUID();
    const run = robot.live.peek().run;
    if (studio.mine.peek() && run !== this.watched) this.answered = run;
    const start = studio.start.start.peek();
    this.now.value = {
      id,
      of: this.subject(),
      n: N_ROBOTS,
      rows: [],
      end: null,
      before: last?.reads.case === number ? (last.end?.good.length ?? null) : null,
      reads: { case: number, run_id: this.answered },
    };
    try {
      this.started = cloudsApi.begin({
        id,
        version_id: version.id,
        world: studio.worlds.name.peek(),
        ...this.robot(),
        ...(start ? { start } : {}),
        ...this.now.value.reads,
      });
      await this.started;
    } catch (error) {
      if (this.now.peek()?.id === id) this.now.value = null;
      throw error;
    }
  }

  /** Ends a cloud that is under way; the robots that have arrived stay on the floor. */
  stop(): void {
    const now = this.now.peek();
    if (now && !now.end)
      this.started
        .then(
          () => cloudsApi.stop(now.id),
          () => {},
        )
        .catch(report);
  }

  close(): void {
    this.stop();
    this.now.value = null;
  }

  /** Runs the program with the wheels of one of the robots. */
  async runOne(seed: number): Promise<void> {
    const now = this.now.peek();
    if (!now?.end || this.isStale.peek()) return;
    const cloud = now.reads;
    const before = robot.live.peek().run;
    await this.studio.drive({ ...REALISM_PRESETS.wheels, ...this.robot(), seed, cloud });
    const { run } = robot.live.peek();
    if (run !== before) this.watched = run;
  }

  private receive(event: CloudProgressEvent): void {
    const now = this.now.peek();
    if (!now || now.id !== event.cloud || now.end) return;
    const rows = [...now.rows, ...event.rows];
    this.now.value = { ...now, n: event.n, rows, end: event.is_over ? event : null };
  }

  /** The robots, as for a run: on the first level and in a mission the choice is hidden. */
  private robot(): Pick<Setup, "model" | "calibrated_robot"> {
    const { model, calibrated_robot } = this.studio.open.setup.value;
    return { model, calibrated_robot };
  }

  private subject(): string {
    const { open, worlds, start } = this.studio;
    const world = worlds.name.value;
    const own = open.ownWorld.now.value;
    return JSON.stringify([
      open.content.value?.document,
      world,
      own,
      start.start.value,
      this.robot(),
    ]);
  }
}
