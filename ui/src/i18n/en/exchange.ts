import type { exchange as first } from "../pt-BR/exchange";

export const exchange: typeof first = {
  title: "Stick and school folder",
  intro:
    "Here the work of many PCs becomes one collection. Merging a file twice changes nothing, and the order does not matter.",
  places: "Where the files are",
  lookAgain: "Look again",
  nowhere: "No USB stick found.",
  nowhereHint: "Plug one in and wait a moment, or choose the school's folder below.",
  stick: (name: string) => `Stick ${name}`,
  folder: (name: string) => `Folder ${name}`,
  free: (size: string) => `${size} free`,
  readOnly: "can only be read",
  unreachable: "does not answer now",
  noFiles: "No files of PINEL yet.",
  file: (size: string, when: string) => `${size} · ${when}`,
  nameless: "Without names",
  doubles:
    "This file brings groups called “Grupo 1”, “Grupo 2”… If they are here already they appear twice, and only deleting them for good undoes it.",
  cameNameless: "They came without names: the groups are called “Grupo 1”, “Grupo 2”…",
  choose: (name: string) => `Merge ${name}`,
  merge: (n: number) => (n === 1 ? "Merge 1 file" : `Merge ${n} files`),
  merging: (n: number, of: number) => `Merging ${n} of ${of}…`,
  saveHere: "Save the work",
  anonymous: "Without names and texts",
  anonymousHint: "To show others: it does not tell whose work it is.",
  saving: "Saving…",
  what: "What to save",
  everything: "Everything on this PC",
  onlyClass: (name: string) => `Only class ${name}`,
  saved: (name: string, groups: string, runs: string) => `Saved in ${name}: ${groups} and ${runs}.`,
  takeOut: "You can take the stick out.",
  saveIn: (folder: string) => `Save in “${folder}”`,
  results: "What came",
  brought: (computer: string, parts: string) => `${computer}: ${parts}.`,
  lessonCame: "This is a lesson file. To open the lesson here, go to “Lessons”.",
  nothingNew: (computer: string) => `${computer}: nothing new, all of it was here already.`,
  nothingComes: (computer: string) => `${computer}: nothing new.`,
  heldBack: (parts: string) => `Does not come back, as it was deleted for good: ${parts}.`,
  heldBackRest: "Some of this file does not come back, as it was deleted for good.",
  deleted: (parts: string) => `Deleted: ${parts}.`,
  deletedRest: "Deleted here too.",
  only: (computer: string) => `${computer}: names and settings brought up to date.`,
  groups: (n: number) => (n === 1 ? "1 group" : `${n} groups`),
  programs: (n: number) => (n === 1 ? "1 program" : `${n} programs`),
  versions: (n: number) => (n === 1 ? "1 version" : `${n} versions`),
  runs: (n: number) => (n === 1 ? "1 run" : `${n} runs`),
  heard: "PCs whose work is already gathered here",
  heardNobody: "There is no work of another PC yet.",
  computer: "PC",
  exported: "File made",
  merged: "Merged",
  heardRuns: "Runs",
  clock: "Times are those of each PC's clock, which may be wrong.",
  shared: "School folder",
  sharedHint:
    "A folder of the network or of this PC that is shown here like a stick. Leave it empty to use none.",
  sharedExample: "For example: \\\\server\\robotics or /network/robotics",
  sharedSilent: {
    message: "The school folder does not answer now.",
    remedy: "It stays chosen. See that the network is up, or that the folder opens on this PC.",
  },
  sharedBackups: "Keep copies of this PC's backups there too",
  sharedBackupsHint: "Whoever can read that folder can read the work of the groups.",
  keepShared: "Use this folder",
  doomed: (computer: string, names: string, work: string) =>
    `On ${computer} this was deleted for good: ${names} (still here: ${work}). Delete it here too? This cannot be undone.`,
  deleteToo: "Delete it here too",
  deleteRest: "Delete the rest here too",
  undecided: {
    title: "Waiting for your decision",
    line: (computer: string, work: string) =>
      `On ${computer} this was deleted for good, and it is still here: ${work}.`,
    file: (name: string, when: string) => `File ${name}, ${when}`,
    ask: "Decide now",
  },
  whatToKeep: "Tick what is to stay, here and on all PCs. What is not ticked is deleted:",
  programOf: (name: string, group: string) => `${name} (${group})`,
  isNow: (classroom: string) => `It is in class ${classroom} now.`,
  isNowWithout: "It is in no class now.",
  isNew: (parts: string) => `Newer here: ${parts}.`,
  edits: (n: number) => (n === 1 ? "1 change" : `${n} changes`),
  kept: (names: string) => `Kept on all PCs: ${names}.`,
  keepHere: "Delete nothing",
  unconfirmed: {
    came: "The work is here; its activities count once PINEL has checked them, which it does by itself.",
    waiting: (n: number) =>
      n === 1
        ? "1 run waits to be checked. PINEL checks by itself while nobody runs programs here."
        : `${n} runs wait to be checked. PINEL checks by itself while nobody runs programs here.`,
    wrong: (n: number) =>
      n === 1
        ? "1 run does not hold: repeated here, it came out otherwise. Its activity does not count."
        : `${n} runs do not hold: repeated here, they came out otherwise. Their activities do not count.`,
    wrongWhere: "The page of the lesson shows whose.",
    notRepeatable: (n: number) =>
      n === 1
        ? "1 run cannot be repeated here, for example because it is of a real robot. It counts if you accept it on the page of the lesson."
        : `${n} runs cannot be repeated here, for example because they are of a real robot. They count if you accept them on the page of the lesson.`,
  },
  deletion: {
    title: "Delete for good",
    hint: "For when a class leaves, or somebody asks for their data to be deleted. All of it goes from this PC and from its backups, and no stick brings it back.",
    what: "What to delete",
    nothing: "Choose a group or the class…",
    group: (name: string) => `Group ${name}`,
    classroom: (name: string) => `All of class ${name}, with its groups`,
    goes: (name: string, programs: string, runs: string) =>
      `${name}: ${programs} and ${runs} will be deleted. This cannot be undone.`,
    go: "Delete for good",
    cancel: "Leave it as it is",
    done: (groups: string, programs: string, runs: string) =>
      `Deleted: ${groups}, ${programs}, ${runs}.`,
    left: "Delete these files too, which may still hold that work:",
  },
};
