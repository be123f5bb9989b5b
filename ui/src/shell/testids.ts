import { KIT_TEST } from "../kit/testids";

/**
 * `data-testid` values for the end-to-end tests, independent of text, style and language. Those marked "of each" occur
 * once per card, letter or line.
 */
export const TEST = {
  ...KIT_TEST,

  // header
  home: "home",
  headerGroup: "header-group",
  programName: "program-name",
  savedMark: "saved-mark", // data-state: saved | saving | failed | refused (a world with faults)
  openWork: "open-work",
  help: "help", // opens and closes it
  theme: "theme", // data-theme: light | dark | contrast
  language: "language", // a select: pt-BR, en, es
  notice: "notice",
  beginEmpty: "begin-empty",
  problem: "problem",
  unsaved: "unsaved",
  locked: "locked",
  gone: "gone",
  fetchAgain: "fetch-again",

  // real robots
  realRobot: "real-robot", // in the header while a real robot may move
  emergencyStop: "emergency-stop",
  robotName: "robot-name", // of each; data-link
  robotChoice: "robot-choice", // a select: sim and the links that are set up
  beforeRun: "before-run", // the check list
  beforePoint: "before-point", // of each
  beforeGo: "before-go",
  howJudged: "how-judged", // data-state: will_be | by_robot | not_judged
  robotKind: "robot-kind", // of each; data-value
  robotField: "robot-field", // of each; data-name
  robotKeep: "robot-keep",
  robotForget: "robot-forget",
  robotContact: "robot-contact",
  robotFound: "robot-found",
  robotState: "robot-state", // in the header; data-state
  robotNow: "robot-now", // in the teacher's part; data-state
  robotHere: "robot-here", // uses the robot's place as the start
  robotAtStart: "robot-at-start",
  robotPlace: "robot-place", // drawn in the room
  jog: "jog", // of each key; data-direction
  jogFault: "jog-fault",
  robotsFind: "robots-find",
  robotOnNetwork: "robot-on-network", // of each; data-namespace
  robotUse: "robot-use", // of each

  // start
  groupName: "group-name",
  createGroup: "create-group",
  groupCard: "group-card", // of each; data-picture
  classChip: "class-chip", // of each
  teacherLink: "teacher-link", // to the sign-in of the teacher
  prepare: "prepare", // the same, without any group
  signOut: "sign-out",
  lessonChip: "lesson-chip", // title and activity of the open lesson
  turns: "turns", // the reminder to swap
  turnsDone: "turns-done",

  // the teacher's part
  pin: "pin",
  pinAgain: "pin-again",
  pinWait: "pin-wait", // remaining wait
  signIn: "sign-in",
  className: "class-name",
  computerName: "computer-name",
  keepComputer: "keep-computer",
  prepareDone: "prepare-done",
  newPin: "new-pin",
  newPinAgain: "new-pin-again",
  keepPin: "keep-pin",
  swapEvery: "swap-every", // of each; data-minutes
  teacherPart: "teacher-part", // of each; data-part: lessons | classes | computer
  newClass: "new-class",
  makeClass: "make-class",
  renameClass: "rename-class",
  classGroup: "class-group", // of each
  groupRename: "group-rename", // of each group
  moveGroup: "move-group", // of each group: a select
  newGroupName: "new-group-name",
  makeGroup: "make-group",
  lessonTitle: "lesson-title",
  lessonActivity: "lesson-activity", // a select
  lessonGoal: "lesson-goal", // picture of the activity's goal
  showGoal: "show-goal", // in the header, shows it large
  openLesson: "open-lesson",
  lessonNow: "lesson-now",
  closeLesson: "close-lesson",
  lessonRow: "lesson-row", // of each
  lessonPick: "lesson-pick", // of each; a checkbox
  lessonJoin: "lesson-join",
  lessonApart: "lesson-apart", // of each joined lesson
  lessonLink: "lesson-link", // of each
  nameField: "name-field", // of the name being edited
  groupEdit: "group-edit", // on the screen of our work
  groupColor: "group-color", // of each
  groupSave: "group-save",

  // studio
  editor: "editor",
  undo: "undo",
  redo: "redo",
  tidy: "tidy",
  level: "level", // a select: 1, 2, 3
  faultList: "fault-list",
  fault: "fault", // of each
  run: "run", // data-does: run | pause | resume
  stop: "stop",
  world: "world", // a select
  statusLine: "status-line", // data-tone: calm | moving | done | notice | fault
  scene: "scene", // data-phase: phase of the run shown
  poseX: "pose-x", // data-value: metres
  poseY: "pose-y", // data-value: metres
  poseHeading: "pose-heading", // data-value: degrees
  elapsed: "elapsed", // data-value: seconds
  mute: "mute", // data-muted
  talk: "talk",
  talkLine: "talk-line", // of each; data-kind: said | asked | answered
  watch: "watch",
  watchValue: "watch-value", // of each; data-name
  question: "question",
  questionText: "question-text",
  answer: "answer",
  sendAnswer: "send-answer",
  irToggle: "ir-toggle", // opens the program as text
  textTab: "text-tab", // of each; data-tab: python | ir
  pythonText: "python-text", // data-lit: number of the running line
  pythonEmpty: "python-empty", // placeholder without a program
  pythonEdit: "python-edit",
  pythonEditor: "python-editor", // a textarea
  pythonPut: "python-put",
  pythonLeave: "python-leave",
  pythonState: "python-state", // data-state: unchanged | checking | fine | faulty
  step: "step",
  stepOver: "step-over",
  stepOut: "step-out",
  speed: "speed",
  pythonFault: "python-fault", // of each; data-line, data-column
  otherWindow: "other-window", // loads the version saved in another window
  elsewhere: "elsewhere", // loads the version saved on another PC
  swapBack: "swap-back",
  irJson: "ir-json",
  irCopy: "ir-copy",
  capture: "capture",
  captureKind: "capture-kind", // tabs
  captureFind: "capture-find",
  drawnHand: "drawn-hand", // data-hand
  captureLetter: "capture-letter", // of each; data-letter, "" for none
  cameraPicture: "camera-picture", // data-state: off | opening | on | failed
  cameraReady: "camera-ready", // data-ready
  cameraPoint: "camera-point", // data-name, data-finding
  cameraTrouble: "camera-trouble", // data-code
  cameraChoice: "camera-choice", // a select: 0, 1, 2
  reading: "reading", // data-kind: blind | no hand | no letter | two signs | unsure | sure
  expectedSign: "expected-sign", // of each; data-sign, data-seen

  // practice of signs
  practice: "practice", // the way there
  practiceSign: "practice-sign", // of each; data-letter
  practiceHand: "practice-hand", // of each; data-value: right | left
  practiceText: "practice-text", // an input
  practiceSpace: "practice-space",
  practiceBack: "practice-back",
  practiceClear: "practice-clear",
  teachName: "teach-name", // an input
  teachKind: "teach-kind", // still | moves
  teachLetter: "teach-letter", // of each letter that the camera does not know untaught; data-letter
  teachRecord: "teach-record",
  teachTold: "teach-told",
  taughtSign: "taught-sign", // of each; data-sign
  forgetSign: "forget-sign", // of each

  // world editor
  worldChange: "world-change", // opens the editor
  worldEditor: "world-editor",
  worldBoard: "world-board", // data-camera: centre on the floor x, y in metres, and pixels per metre
  worldTool: "world-tool", // of each; data-tool: select | wall | box | zone | paint | start
  worldColor: "world-color", // of each; data-color
  worldThing: "world-thing", // of each; data-kind, data-index in its list, data-faulty
  worldHandle: "world-handle", // of each; data-handle: from | to | 0..3 | radius | turn
  worldHint: "world-hint",
  worldPanel: "world-panel", // data-kind: world | start | wall | box | zone | paint
  worldName: "world-name",
  worldZoneName: "world-zone-name",
  worldMovable: "world-movable", // of each; data-value: false | true
  worldShape: "world-shape", // of each; data-value: rectangle | disc
  worldDelete: "world-delete",
  worldBegin: "world-begin", // a select
  worldFile: "world-file", // an input for a file
  worldExport: "world-export",
  worldForget: "world-forget",
  worldBringBack: "world-bring-back",
  worldUndo: "world-undo",
  worldRedo: "world-redo",
  worldDone: "world-done",
  worldFaults: "world-faults",
  worldFault: "world-fault", // of each; data-code
  worldFaultNote: "world-fault-note",
  worldRefused: "world-refused",
  worldOwnInstead: "world-own-instead",

  startAgain: "start-again",
  sceneTools: "scene-tools", // opens the other tools
  measureTool: "measure-tool", // of each; data-name: ruler | protractor
  measure: "measure", // data-value: metres, or degrees to the left
  lastMark: "last-mark",
  ring: "ring", // of each; data-name: sonar | lidar
  follow: "follow",
  scenePicture: "scene-picture",
  lifelike: "lifelike", // a select: ideal | camera | wheels
  plotsToggle: "plots-toggle",
  plots: "plots",
  plotTab: "plot-tab", // of each; data-figure: path | position | heading | speed | turning
  plot: "plot", // data-figure, data-tick: the selected moment
  plotSize: "plot-size",
  plotSave: "plot-save",
  plotPicture: "plot-picture",
  plotTable: "plot-table",

  // activities that a teacher makes, lesson files
  makingNew: "making-new",
  makingForm: "making-form",
  makingGroup: "making-group", // a select
  makingProgram: "making-program", // a select
  makingWorld: "making-world", // a select
  makingCheck: "making-check", // of each; data-kind
  makingNumber: "making-number", // of each number of a check
  makingTitle: "making-title",
  makingStory: "making-story",
  makingHint: "making-hint", // of each
  makingNotice: "making-notice",
  makingMinutes: "making-minutes",
  makingTry: "making-try",
  makingTrials: "making-trials", // data-right
  makingSave: "making-save",
  makingRow: "making-row", // of each
  makingEdit: "making-edit", // of each
  makingDelete: "making-delete", // of each
  makingUndo: "making-undo",
  presetLevel: "preset-level", // a select
  presetWorld: "preset-world", // a select
  presetActivity: "preset-activity", // a select
  presetSwap: "preset-swap", // a select
  presetSaved: "preset-saved",
  lessonFileSave: "lesson-file-save",
  lessonFileSaveIn: "lesson-file-save-in", // of each folder
  lessonFileOpen: "lesson-file-open", // an input for a file
  lessonFileFound: "lesson-file-found", // of each
  lessonFileDone: "lesson-file-done",

  // our work
  newProgram: "new-program",
  programCard: "program-card", // of each
  runCard: "run-card", // of each; data-state

  noteCard: "note-card", // of each note of the teacher
  noteRun: "note-run", // of each
  noteSeen: "note-seen", // of each
  runFilter: "run-filter", // of each; data-outcome: all | finished | stopped | failed
  runProgram: "run-program", // a select
  throwAway: "throw-away", // of each program
  throwBack: "throw-back",
  bin: "bin",
  binProgram: "bin-program", // of each
  takeBack: "take-back", // of each

  // versions of a program
  openHistory: "open-history", // of the open program, or of each card
  versionStep: "version-step", // of each; data-number of its newest, data-n
  versionUnfold: "version-unfold", // of each burst of edits
  versionFork: "version-fork", // of each
  versionBranch: "version-branch", // of each
  versionSlider: "version-slider", // a range; its value is the place in the line, from 0
  versionOlder: "version-older",
  versionNewer: "version-newer",
  versionBack: "version-back",
  versionCompareFork: "version-compare-fork", // of each fork
  versionShown: "version-shown", // data-number
  versionRename: "version-rename",
  versionName: "version-name",
  versionKeepName: "version-keep-name",
  versionGoOn: "version-go-on",
  versionReturn: "version-return", // to the version that was replaced by a restored one
  versionCompare: "version-compare",
  versionBlocks: "version-blocks",
  differenceSide: "difference-side", // of each; a select, data-side: before | after
  difference: "difference", // of each; data-kind: added | removed | changed | moved
  openActivities: "open-activities",
  activityCard: "activity-card", // of each; data-activity, data-state: new | tried | passed
  examples: "examples",
  toExamples: "to-examples",
  exampleCard: "example-card", // of each; data-example
  tour: "tour", // data-step: see tour/steps.ts
  tourRing: "tour-ring", // of each
  tourGo: "tour-go",
  tourShow: "tour-show", // after 20 s in a step
  tourSkip: "tour-skip",
  tourMission: "tour-mission",
  tourFree: "tour-free",
  helpTour: "help-tour",
  helpPanel: "help-panel",
  helpSearch: "help-search",
  helpTab: "help-tab", // of each; data-tab: tasks | blocks | keys
  helpBlock: "help-block", // of each; data-block
  helpFilm: "help-film", // of each block that moves the robot; data-part: from 0 to 1
  helpTry: "help-try", // of each block
  helpTask: "help-task", // of each; data-task
  helpExample: "help-example", // of each; data-example
  helpClose: "help-close",
  mission: "mission", // data-done
  lessonMission: "lesson-mission",
  missionFold: "mission-fold",
  missionHint: "mission-hint",
  missionDone: "mission-done",
  missionNext: "mission-next",
  missionOthers: "mission-others",
  checks: "checks", // data-state of each line
  casesTried: "cases-tried",
  adviceBlock: "advice-block",
  successSound: "success-sound",
  worldLocked: "world-locked",
  setupDifferences: "setup-differences",
  differenceNext: "difference-next",
  differencePrevious: "difference-previous",
  differenceCount: "difference-count",

  // the run that is over, under the floor of the studio
  pastRun: "past-run",
  pastRunSlider: "past-run-slider", // a range; its value is the tick
  pastRunReplay: "past-run-replay",

  // replay
  replaySlider: "replay-slider", // a range; its value is the tick
  replayPlay: "replay-play", // data-does: play | pause
  replayBack: "replay-back",
  replayForward: "replay-forward",
  replaySpeed: "replay-speed",
  replayProgram: "replay-program",
  backToReview: "back-to-review", // in the header, for the teacher
  mergeFiles: "merge-files",
  foundFile: "found-file",
  computerTrust: "computer-trust",
  approveComputer: "approve-computer",
  unconfirmed: "unconfirmed",
  computerCode: "computer-code",
  mergeResults: "merge-results",
  undecided: "undecided", // deletions of other PCs that nobody decided about
  wouldDelete: "would-delete", // deletions that a file contains
  deleteToo: "delete-too",
  canKeep: "can-keep", // a group or program of such a deletion
  saveBundle: "save-bundle",
  exportLeftOut: "export-left-out",
  sharedFolder: "shared-folder",
  sharedBackups: "shared-backups", // copies of the backups go there too
  deleted: "deleted", // the open program was deleted for good
  takeText: "take-text", // saves its text as a file
  deletionOpen: "deletion-open",
  deletionWhat: "deletion-what", // a select
  deletionGo: "deletion-go",
  deletionDone: "deletion-done",
  programFile: "program-file", // exports the program
  bringProgram: "bring-program", // an input for a file

  // the lesson plan and its cards
  plan: "plan",
  planStep: "plan-step", // of each; data-name
  planOpen: "plan-open", // opens an activity for the class; data-name, aria-pressed
  planCards: "plan-cards",
  planPrint: "plan-print",
  planSave: "plan-save",
  cards: "cards", // data-list, data-ink
  card: "card", // of each; data-name
  cardsList: "cards-list", // a select
  cardsCopies: "cards-copies", // a select
  cardsInk: "cards-ink", // of each; data-value: lines | colours
  cardsPrint: "cards-print",
  cardsSave: "cards-save",

  // the teacher's review
  lessonPage: "lesson-page",
  lessonEmpty: "lesson-empty",
  lessonTime: "lesson-time", // of each; data-value: group | clock
  lessonSummary: "lesson-summary",
  lessonStuck: "lesson-stuck", // of each group that needs help
  lessonTable: "lesson-table",
  lessonPrint: "lesson-print",
  lessonExplained: "lesson-explained",
  reviewGroup: "review-group", // of each; data-name, data-need: help | working | passed
  reviewOpen: "review-open", // of each
  reviewMark: "review-mark", // of each; data-kind: edit | run, data-outcome, data-repairs: a run
  reviewFigure: "review-figure", // of each; data-name, data-value
  reviewDetail: "review-detail",
  reviewHints: "review-hints",
  reviewRun: "review-run", // of each; data-outcome
  reviewRepair: "review-repair", // of each
  reviewRefresh: "review-refresh", // data-at: time of the data shown
  note: "note", // data-state: unchanged | changed | saving | saved
  noteOpen: "note-open",
  noteText: "note-text", // a textarea
  noteSave: "note-save",
  noteDelete: "note-delete", // asks for confirmation
  noteDeleteSure: "note-delete-sure",
  historyPage: "history-page",
  historyFilter: "history-filter", // of each; data-name: classroom | group | lesson | activity | world | day | outcome
  historyRun: "history-run", // of each; data-outcome
  historyPlace: "history-place", // world and lesson, of each
  historyOlder: "history-older",
  historyEmpty: "history-empty",
  compareHints: "compare-hints", // of each run
  compareChoose: "compare-choose", // of each; an input
  compareOpen: "compare-open",
  comparePage: "compare-page",
  compareSide: "compare-side", // of each; data-phase
  compareView: "compare-view", // of each; data-value: apart | together
} as const;
