import { ArrowLeft, ChevronDown, Contrast, Languages, Moon, Route, Sun } from "lucide-preact";
import { opened } from "../app/open_program";
import { reviewPlace } from "../app/review_place";
import { go, hashOf, route } from "../app/route";
import { chooseLanguage, group } from "../app/session";
import { TEST } from "../app/testids";
import { nextTheme, setTheme, theme } from "../app/theme";
import { language, texts } from "../i18n";
import { isLanguage, LANGUAGES } from "../i18n/language";
import { GroupPicture } from "./GroupPicture";
import { LessonChip } from "./LessonChip";
import { Mark } from "./Mark";
import { ProgramName } from "./ProgramName";
import { SavedMark } from "./SavedMark";
import { TeacherChip } from "./TeacherChip";

const LANGUAGE_NAMES = { "pt-BR": "Português", en: "English", es: "Español" } as const;
const THEME_ICONS = { light: Sun, dark: Moon, contrast: Contrast } as const;

/** Screens that are about no group in particular. */
const OUTSIDE = ["start", "teacher", "lesson", "runs", "compare"];

/** The same places on every screen: who, what, saved, our work, look, language. */
export function Header() {
  const inside = !OUTSIDE.includes(route.value.screen);
  return (
    <header class="header">
      <a class="header__home" href="#/" data-testid={TEST.home} title={texts.value.header.home}>
        <Mark />
        <span class="header__brand">PINEL</span>
      </a>
      {inside && <GroupChip />}
      {inside && <ProgramName />}
      {route.value.screen === "studio" && <SavedMark />}
      {route.value.screen === "studio" && <LessonChip />}
      <span class="header__space" />
      <TeacherChip />
      {inside && <WorkButton />}
      <ThemeButton />
      <LanguageChoice />
    </header>
  );
}

function GroupChip() {
  const now = group.value;
  if (!now) return null;
  return (
    <a
      class="header__group tinted"
      href="#/"
      title={`${texts.value.header.group}: ${now.name}. ${texts.value.header.home}`}
      data-testid={TEST.headerGroup}
      style={{ "--group": now.color }}
    >
      <span class="badge">
        <GroupPicture name={now.picture} />
      </span>
      <span class="header__group-name" dir="auto">
        {now.name}
      </span>
    </a>
  );
}

function WorkButton() {
  const { header } = texts.value;
  const now = route.value;
  if (reviewPlace.value) {
    const word = reviewPlace.value.screen === "lesson" ? header.backToLesson : header.backToRuns;
    return (
      <a
        class="button"
        href={hashOf(reviewPlace.value)}
        aria-label={word}
        title={word}
        data-testid={TEST.backToReview}
      >
        <ArrowLeft class="icon" aria-hidden="true" />
        <span class="header__word">{word}</span>
      </a>
    );
  }
  if (now.screen === "work") {
    const program = opened.value?.program;
    if (program?.group_id !== now.group) return null;
    return (
      <a class="button" href={hashOf({ screen: "studio", program: program.id })}>
        <ArrowLeft class="icon" aria-hidden="true" />
        <span class="header__word">{header.backToProgram}</span>
      </a>
    );
  }
  return (
    <button
      type="button"
      class="button"
      data-testid={TEST.openWork}
      aria-label={header.work}
      disabled={!group.value}
      onClick={() => group.value && go({ screen: "work", group: group.value.id })}
    >
      <Route class="icon" aria-hidden="true" />
      <span class="header__word">{header.work}</span>
    </button>
  );
}

function ThemeButton() {
  const { header } = texts.value;
  const Icon = THEME_ICONS[theme.value];
  const label = header.changeTheme(header.theme[theme.value]);
  return (
    <button
      type="button"
      class="button button--icon"
      data-testid={TEST.theme}
      data-theme={theme.value}
      aria-label={label}
      title={label}
      onClick={() => setTheme(nextTheme(theme.value))}
    >
      <Icon class="icon" aria-hidden="true" />
    </button>
  );
}

function LanguageChoice() {
  return (
    <span class="select">
      <Languages class="icon" aria-hidden="true" />
      <select
        aria-label={texts.value.header.language}
        data-testid={TEST.language}
        value={language.value}
        onChange={(event) => {
          const { value } = event.currentTarget;
          if (isLanguage(value)) void chooseLanguage(value);
        }}
      >
        {LANGUAGES.map((name) => (
          <option key={name} value={name} lang={name}>
            {LANGUAGE_NAMES[name]}
          </option>
        ))}
      </select>
      <ChevronDown class="icon icon--end" aria-hidden="true" />
    </span>
  );
}
