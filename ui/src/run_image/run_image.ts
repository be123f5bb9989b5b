import { activitiesApi } from "../api/activities";
import { api } from "../api/client";
import type { RunWithVersion } from "../api/model";
import { type DrawnStack, drawProgram } from "../editor/reader/program_drawing";
import { language, texts } from "../i18n";
import { RecordedStates } from "../run/recorded_states";
import { activeBlockId } from "../run/reducer";
import { decodeTelemetry } from "../run/telemetry";
import { paperColours } from "../scene/colours";
import { liveryOf } from "../scene/livery/livery";
import { fileName, saveFile } from "../shell/files/save_file";
import { group, robotOf } from "../shell/session";
import type { Progress } from "./animation";
import { floorSize, type PicturedRun, RecordedFloor } from "./floor";
import { FRAME_FORMAT, Page, type PageFormat, type PageTexts, PRINT_FORMAT } from "./page";

/** Saves a picture of the end of a run, with its whole path. */
export async function savePicture(runId: string): Promise<void> {
  const { pictured, page, floor } = await prepare(runId, PRINT_FORMAT);
  page.draw(floor.at(pictured.history.lastTick));
  floor.dispose();
  const image = await new Promise<Blob | null>((done) => page.canvas.toBlob(done, "image/png"));
  if (image) saveFile(nameOf(pictured.run, "png"), image);
}

/** Saves an animation of a run. Draws one frame at a time, so that the page stays usable meanwhile. */
export async function saveAnimation(runId: string, progress: Progress): Promise<void> {
  const [{ pictured, page, floor }, { encodeAnimation }] = await Promise.all([
    prepare(runId, FRAME_FORMAT),
    import("./animation"),
  ]);
  const { history, run } = pictured;
  const draw = (tick: number, speed: number) => {
    page.draw(floor.at(tick), activeBlockId(history.at(Math.floor(tick))), speed);
    return page.pixels;
  };
  try {
    const file = await encodeAnimation(history.lastTick, draw, progress);
    if (file) saveFile(nameOf(run, "gif"), file);
  } finally {
    floor.dispose();
  }
}

/** Loads a run, and makes the page and the floor of its pictures. */
async function prepare(runId: string, format: PageFormat) {
  const pictured = await load(runId);
  const { run } = pictured;
  const [stacks, mission] = await Promise.all([stacksOf(run), missionOf(run)]);
  const colours = paperColours();
  const size = floorSize(pictured, format.floorWidth);
  const page = new Page(format, textsOf(pictured, mission), size, stacks, colours);
  return { pictured, page, floor: new RecordedFloor(pictured, size, format.ratio, colours) };
}

async function load(runId: string): Promise<PicturedRun> {
  const [run, events, samples] = await Promise.all([
    api.run(runId),
    api.runEvents(runId),
    api.runTelemetry(runId),
  ]);
  const owner = group.peek()?.id === run.group_id ? group.peek() : null;
  return {
    run,
    history: new RecordedStates(runId, events, decodeTelemetry(samples)),
    robot: robotOf(run.model),
    livery: liveryOf(owner),
  };
}

/** The blocks of the program; none for a run of the command line. */
async function stacksOf({ version }: RunWithVersion): Promise<readonly DrawnStack[]> {
  return version ? drawProgram(version.workspace, language.peek()) : [];
}

/** The mission of the run and whether it was passed, in words. */
async function missionOf({ activity: name, passed }: RunWithVersion): Promise<string> {
  if (!name) return "";
  // a teacher's activity may be missing here, and has no number
  const found = await activitiesApi.one(name).catch(() => null);
  if (!found) return "";
  const title = `${found.number} ${found.title}`.trim();
  const { runImage } = texts.peek();
  if (passed === null) return runImage.mission({ title });
  return passed ? runImage.passed({ title }) : runImage.notPassed({ title });
}

function textsOf({ run, livery }: PicturedRun, mission: string): PageTexts {
  const owner = group.peek()?.id === run.group_id ? (group.peek()?.name ?? "") : "";
  const day = new Date(run.started_at).toLocaleDateString(language.peek(), { dateStyle: "long" });
  const robot = livery && texts.peek().runImage.robot({ name: livery.name });
  return {
    title: run.program_name ?? texts.peek().work.noName,
    mission,
    owner,
    facts: [robot, day, "PINEL"].filter(Boolean).join(" · "),
  };
}

function nameOf(run: RunWithVersion, ending: string): string {
  const owner = group.peek()?.id === run.group_id ? group.peek()?.name : "";
  return `${fileName([owner, run.program_name].filter(Boolean).join(" "), "pinel")}.${ending}`;
}
