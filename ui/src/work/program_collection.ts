import { signal } from "@preact/signals";
import { api } from "../api/client";
import type { Program } from "../api/model";
import { versionsApi } from "../api/versions";
import { opened } from "../studio/program/open_program";

/** A group's programs, its bin, and the last discarded program. */
export class ProgramCollection {
  readonly programs = signal<Program[]>([]);
  readonly bin = signal<Program[]>([]);
  readonly thrown = signal<Program | null>(null);

  constructor(private readonly group: string) {}

  async load(): Promise<void> {
    const [programs, bin] = await Promise.all([
      api.programs(this.group),
      versionsApi.bin(this.group),
    ]);
    this.bin.value = bin;
    this.programs.value = programs;
  }

  /** Moves a program to the bin without confirmation; undo is offered. */
  async throwAway(program: Program): Promise<void> {
    const thrown = await versionsApi.throwAway(program.id);
    this.programs.value = without(this.programs.peek(), program);
    // the header must not link to a program in the bin
    if (opened.peek()?.id === program.id) opened.value = null;
    this.bin.value = [thrown, ...without(this.bin.peek(), program)];
    this.thrown.value = thrown;
  }

  async restore(program: Program): Promise<void> {
    const back = await versionsApi.restore(program.id);
    this.bin.value = without(this.bin.peek(), program);
    const others = without(this.programs.peek(), program);
    this.programs.value = [...others, back].sort((one, other) => (one.id < other.id ? 1 : -1));
    if (this.thrown.peek()?.id === program.id) this.thrown.value = null;
  }
}

function without(programs: readonly Program[], program: Program): Program[] {
  return programs.filter(({ id }) => id !== program.id);
}
