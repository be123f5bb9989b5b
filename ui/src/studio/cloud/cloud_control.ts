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
  /** How many did it in the cloud before; null without one. */
  readonly before: number | null;
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
  readonly bundle = computed<Bundle | null>(() => {
    const { value: now } = this.now;
    if (!now || chosenRobot.value) return null;
    const paths = now.rows.map(({ seed, well, path }) => ({ id: seed, well, path }));
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

  async begin(): Promise<void> {
    const { studio } = this;
    const before = this.now.peek()?.end ?? null;
    const version = await studio.savedVersion();
    if (!version) return;
    const id = crypto.randomUUID();
    const last = robot.live.peek().run;
    const start = studio.start.start.peek();
    const n = N_ROBOTS;
    this.now.value = {
      id,
      of: this.subject(),
      n,
      rows: [],
      end: null,
      before: before?.n_good ?? null,
    };
    try {
      this.started = cloudsApi.begin({
        id,
        version_id: version.id,
        world: studio.worlds.name.peek(),
        ...this.robot(),
        ...(start ? { start } : {}),
        ...(last && studio.mine.peek() ? { run_id: last } : {}),
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
  runOne(seed: number): Promise<void> {
    if (this.isStale.peek() || this.isRunning.peek()) return Promise.resolve();
    return this.studio.drive({ ...REALISM_PRESETS.wheels, ...this.robot(), seed, cloud: true });
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
