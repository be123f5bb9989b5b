import { batch, computed, signal } from "@preact/signals";
import { OWN_WORLD, type World } from "../api/model";
import type { OpenProgram } from "../app/open_program";
import { worlds } from "../app/session";
import { texts } from "../i18n";
import * as robot from "../run/live";
import { isLive } from "../run/reducer";
import { WorldDesk } from "./desk";

/** A world that ships, chosen once and kept from program to program. */
const chosen = signal<string | null>(null);

/** Where a program's robot drives: in a world that ships, or in the one that the group has made. */
export class WorldControl {
  private readonly usesOwn = signal(false);
  /** Deleted just now, for who wants it back. */
  readonly forgotten = signal<World | null>(null);
  /** The editor's table while it is open. */
  readonly desk = signal<WorldDesk | null>(null);
  private lastDesk: WorldDesk | null = null;

  readonly name = computed(() => {
    const { value: run } = robot.liveRun;
    if (run && isLive(robot.live.value)) return run.world;
    if (this.usesOwn.value && this.open.ownWorld.now.value) return OWN_WORLD;
    return chosen.value ?? worlds.value[0]?.name ?? "";
  });
  readonly world = computed<World | null>(() => {
    const { value: run } = robot.liveRun;
    if (run && isLive(robot.live.value) && "world_document" in run) return run.world_document;
    if (this.name.value === OWN_WORLD) return this.open.ownWorld.now.value;
    return worlds.value.find((world) => world.name === this.name.value) ?? null;
  });
  /** The robot would drive in a world that the server does not take. */
  readonly isFaulty = computed(
    () => this.name.value === OWN_WORLD && this.open.ownWorld.isRefused.value,
  );
  /** What is on the table would take the place of the group's own world. */
  readonly replaces = computed(
    () => this.desk.value !== null && !this.usesOwn.value && this.open.ownWorld.now.value !== null,
  );

  constructor(private readonly open: OpenProgram) {
    this.usesOwn.value = open.ownWorld.now.peek() !== null;
  }

  choose(name: string): void {
    batch(() => {
      this.usesOwn.value = name === OWN_WORLD;
      if (name !== OWN_WORLD) chosen.value = name;
      robot.clear();
    });
  }

  /** Puts the world that is chosen on the editor's table; one that ships as a copy, not kept before it is changed. */
  edit(): void {
    const world = this.world.peek();
    if (!world || isLive(robot.live.peek())) return;
    if (this.name.peek() === OWN_WORLD) this.desk.value = this.deskOf(world);
    else this.desk.value = this.newDesk(copyOf(world), this.open.ownWorld.now.peek());
  }

  editOwn(): void {
    this.choose(OWN_WORLD);
    this.edit();
  }

  done(): void {
    this.desk.value = null;
  }

  forget(): void {
    batch(() => {
      this.forgotten.value = this.open.ownWorld.now.peek();
      this.done();
      this.usesOwn.value = false;
      this.open.setWorld(null);
      robot.clear();
    });
  }

  bringBack(): void {
    const { value: world } = this.forgotten;
    if (world) this.keep(world);
  }

  /** The way back lasts as long as nobody else changes the world. */
  private deskOf(world: World): WorldDesk {
    return this.lastDesk?.document.peek() === world ? this.lastDesk : this.newDesk(world);
  }

  private newDesk(world: World, before: World | null = null): WorldDesk {
    const desk = new WorldDesk(world, (document) => this.keep(document), before);
    desk.faults.subscribe((faults) => {
      if (faults.length > 0) this.open.ownWorld.refuse(desk.document.peek());
    });
    this.lastDesk = desk;
    return desk;
  }

  private keep(world: World): void {
    batch(() => {
      this.forgotten.value = null;
      this.usesOwn.value = true;
      this.open.setWorld(world);
      robot.clear();
    });
  }
}

const copyOf = (world: World): World => ({
  ...world,
  name: OWN_WORLD,
  title: texts.peek().world.own,
});
