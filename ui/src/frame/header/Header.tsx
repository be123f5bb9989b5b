import {
  ArrowLeft,
  BookText,
  CircleQuestionMark,
  Contrast,
  Hand,
  Languages,
  Moon,
  Route,
  Sun,
  Target,
} from "lucide-preact";
import { useRef } from "preact/hooks";
import { hasCapture } from "../../camera/expected";
import { language, texts } from "../../i18n";
import { LANGUAGES, languageRow } from "../../i18n/languages";
import { labelled } from "../../i18n/phrases";
import { Button } from "../../kit/Button";
import { LinkButton } from "../../kit/LinkButton";
import { GroupPicture } from "../../kit/pictures/GroupPicture";
import { Select } from "../../kit/Select";
import { helpIsOpen } from "../../shell/help";
import { go, hashOf, ROUTES, route, type ScreenName } from "../../shell/route";
import { chooseLanguage, group } from "../../shell/session";
import { reviewOrigin } from "../../shell/teacher/review_origin";
import { nextTheme, setTheme, theme } from "../../shell/theme";
import { opened } from "../../studio/program/open_program";
import { AlbumLink } from "./AlbumLink";
import { LessonChip } from "./LessonChip";
import { Logo } from "./Logo";
import { useOverflow } from "./overflow";
import { ProgramName } from "./ProgramName";
import { RealRobot } from "./RealRobot";
import { SaveStatus } from "./SaveStatus";
import { TeacherChip } from "./TeacherChip";

const THEME_ICONS = { light: Sun, dark: Moon, contrast: Contrast } as const;

/**
 * The header: group, program, save status, links and settings, in the same order on every screen.
 */
export function Header() {
  const inside = ROUTES[route.value.screen].ofGroup;
  const header = useRef<HTMLElement>(null);
  useOverflow(header);
  return (
    <header class="header row middle rigid gap-2" ref={header}>
      <a
        class="header__home row middle gap-2"
        href="#/"
        data-testid="home"
        title={texts.value.header.home}
      >
        <Logo />
        <span class="header__brand">PINEL</span>
      </a>
      {inside && <GroupChip />}
      {inside && <ProgramName />}
      {route.value.screen === "studio" && <SaveStatus />}
      {route.value.screen === "studio" && <LessonChip />}
      <span class="grows" />
      <RealRobot />
      <TeacherChip />
      {route.value.screen === "studio" && <PracticeLink />}
      {inside && route.value.screen !== "activities" && <ActivitiesLink />}
      {inside && !HAS_ALBUM_LINK.includes(route.value.screen) && <AlbumLink />}
      {inside && <WorkButton />}
      {isBesideProgram(route.value.screen) && <BackToProgram />}
      {route.value.screen === "studio" && <HelpButton />}
      {route.value.screen === "start" && <ManualsLink />}
      <ThemeButton />
      <LanguageChoice />
    </header>
  );
}

const BESIDE_PROGRAM: readonly ScreenName[] = ["practice", "activities", "album"];
/** The album, and screens with a link to it. */
const HAS_ALBUM_LINK: readonly ScreenName[] = ["album", "work"];

const isBesideProgram = (screen: ScreenName) => BESIDE_PROGRAM.includes(screen);

function GroupChip() {
  const now = group.value;
  if (!now) return null;
  return (
    <a
      class="header__group tinted row middle gap-2"
      href="#/"
      title={`${labelled(texts.value.header.group, now.name)}. ${texts.value.header.home}`}
      data-testid="header-group"
      style={{ "--group": now.color }}
    >
      <span class="badge">
        <GroupPicture name={now.picture} />
      </span>
      <span class="header__group-name one-line" dir="auto">
        {now.name}
      </span>
    </a>
  );
}

function WorkButton() {
  const { header } = texts.value;
  const now = route.value;
  if (reviewOrigin.value) {
    const label = reviewOrigin.value.screen === "lesson" ? header.backToLesson : header.backToRuns;
    return (
      <LinkButton
        href={hashOf(reviewOrigin.value)}
        icon={ArrowLeft}
        label={label}
        tip={label}
        testId="back-to-review"
      >
        <span class="header__word">{label}</span>
      </LinkButton>
    );
  }
  if (now.screen === "work") return <BackToProgram />;
  return (
    <Button
      icon={Route}
      label={header.work}
      testId="open-work"
      disabled={!group.value}
      onPress={() => group.value && go({ screen: "work", group: group.value.id })}
    >
      <span class="header__word header__work-word">{header.work}</span>
    </Button>
  );
}

function ActivitiesLink() {
  const { value: now } = group;
  if (!now || reviewOrigin.value) return null;
  const { open } = texts.value.activity;
  return (
    <LinkButton
      icon={Target}
      label={open}
      href={hashOf({ screen: "activities", group: now.id })}
      testId="open-activities"
    >
      <span class="header__word">{open}</span>
    </LinkButton>
  );
}

function HelpButton() {
  const { help } = texts.value.header;
  return (
    <Button
      icon={CircleQuestionMark}
      label={help}
      tip={help}
      testId="help"
      open={helpIsOpen.value}
      onPress={() => {
        helpIsOpen.value = !helpIsOpen.peek();
      }}
    >
      <span class="header__word header__help-word">{help}</span>
    </Button>
  );
}

/** Link to the manuals, for who sets up the PC. */
function ManualsLink() {
  const { manuals } = texts.value.titles;
  return (
    <LinkButton
      icon={BookText}
      label={manuals}
      tip={manuals}
      href={hashOf({ screen: "manuals", manual: null, section: null })}
      testId="manuals-link"
    >
      <span class="header__word">{manuals}</span>
    </LinkButton>
  );
}

/** Link to the practice of signs, for a program that waits for signs. */
function PracticeLink() {
  if (!hasCapture(opened.value?.content.value?.document)) return null;
  return (
    <LinkButton
      icon={Hand}
      label={texts.value.titles.practice}
      href={hashOf({ screen: "practice" })}
      testId="practice"
    />
  );
}

function BackToProgram() {
  const program = opened.value?.program;
  // the group before may have left its program open
  if (!program || program.group_id !== group.value?.id) return null;
  return (
    <LinkButton
      icon={ArrowLeft}
      label={texts.value.header.backToProgram}
      href={hashOf({ screen: "studio", program: program.id })}
    >
      <span class="header__word">{texts.value.header.backToProgram}</span>
    </LinkButton>
  );
}

function ThemeButton() {
  const { header } = texts.value;
  return (
    <Button
      icon={THEME_ICONS[theme.value]}
      label={header.changeTheme({ now: header.theme[theme.value] })}
      testId="theme"
      data-theme={theme.value}
      onPress={() => setTheme(nextTheme(theme.value))}
    />
  );
}

function LanguageChoice() {
  return (
    <Select
      icon={Languages}
      class="header__language"
      label={texts.value.header.language}
      tip={texts.value.header.language}
      testId="language"
      value={language.value}
      options={LANGUAGES.map((tag) => [tag, languageRow(tag).name, { lang: tag }])}
      onChange={chooseLanguage}
    />
  );
}
