import { computed } from "@preact/signals";
import { type Language, language } from "../i18n";
import { en } from "../i18n/exchange/en";
import { es } from "../i18n/exchange/es";
import { type ExchangeTexts, ptBR } from "../i18n/exchange/pt-BR";

export const EXCHANGE_TEXTS: Record<Language, ExchangeTexts> = { "pt-BR": ptBR, en, es };

/** The words of sticks and of deleting: a catalogue of its own, so that pupils need not fetch it. */
export const words = computed<ExchangeTexts>(() => EXCHANGE_TEXTS[language.value]);
