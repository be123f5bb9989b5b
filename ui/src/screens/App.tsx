import { route } from "../app/route";
import { connection } from "../app/session";
import { Header } from "./Header";
import { Locked } from "./Locked";
import { laterScreen } from "./later";
import { Messages } from "./Messages";
import { StartScreen } from "./StartScreen";
import { StudioScreen } from "./StudioScreen";

const WorkScreen = laterScreen(async () => (await import("./WorkScreen")).WorkScreen);
const ReplayScreen = laterScreen(async () => (await import("./ReplayScreen")).ReplayScreen);
const VersionsScreen = laterScreen(async () => (await import("../versions")).VersionsScreen);
const DifferencesScreen = laterScreen(async () => (await import("../versions")).DifferencesScreen);
const TeacherScreen = laterScreen(
  async () => (await import("../teacher/TeacherScreen")).TeacherScreen,
);
const LessonScreen = laterScreen(async () => (await import("../review/LessonScreen")).LessonScreen);
const RunsScreen = laterScreen(async () => (await import("../review/RunsScreen")).RunsScreen);
const CompareScreen = laterScreen(
  async () => (await import("../review/CompareScreen")).CompareScreen,
);

export function App() {
  if (connection.value === "locked") return <Locked />;
  return (
    <div class="page">
      <Header />
      <Messages />
      <Screen />
    </div>
  );
}

function Screen() {
  const now = route.value;
  if (connection.value === "opening") return <main class="screen" aria-busy="true" />;
  switch (now.screen) {
    case "studio":
      return <StudioScreen key={now.program} programId={now.program} />;
    case "work":
      return <WorkScreen key={now.group} groupId={now.group} />;
    case "replay":
      return <ReplayScreen key={now.run} runId={now.run} />;
    case "versions":
      return <VersionsScreen key={now.program} programId={now.program} versionId={now.version} />;
    case "differences":
      return <DifferencesScreen key={`${now.before} ${now.after}`} {...now} />;
    case "teacher":
      return <TeacherScreen part={now.part} />;
    case "lesson":
      return <LessonScreen key={now.lesson} lessonId={now.lesson} />;
    case "runs":
      return <RunsScreen />;
    case "compare":
      return <CompareScreen key={now.runs.join()} runs={now.runs} />;
    default:
      return <StartScreen />;
  }
}
