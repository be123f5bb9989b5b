import { computed } from "@preact/signals";
import { type Language, language } from "../i18n";
import { en } from "../i18n/teacher/en";
import { es } from "../i18n/teacher/es";
import { ptBR, type TeacherTexts } from "../i18n/teacher/pt-BR";

export const TEACHER_TEXTS: Record<Language, TeacherTexts> = { "pt-BR": ptBR, en, es };

/** The words of the teacher's part: a catalogue of its own, so that pupils need not fetch it. */
export const words = computed<TeacherTexts>(() => TEACHER_TEXTS[language.value]);
